// One time step: positions at its start and its end, as two views. Nothing is copied.
#pragma once
#include "tamis/positions.hpp"

namespace tamis {

/// Each vertex moves on a straight line from `start` (t=0) to `end` (t=1).
struct Step {
  Positions start;  ///< positions at t=0
  Positions end;    ///< positions at t=1
};

}  // namespace tamis

// Where every vertex is at the start and at the end of a time step: two views, nothing is copied.
#pragma once
#include "tamis/positions.hpp"

namespace tamis {

/// One time step: each vertex moves on a straight line from `start` (t=0) to `end` (t=1).
struct Step {
  Positions start;
  Positions end;
};

}  // namespace tamis

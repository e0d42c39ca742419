// The oracle of two turning bodies: the first touch of all pairs of their features, each by itself.
#pragma once
#include <vector>

#include "oracle/turning.hpp"
#include "tamis/mesh.hpp"

namespace tamis::oracle {

struct TurningBody {
  std::vector<Point> points;  ///< in its own frame
  std::vector<Face> faces;
  Turning motion;
};

/// The first time at which the bodies are nearer than `separation` and 1e-15, as apart_until; above 1: never.
Real first_touch(const TurningBody& first, const TurningBody& second, Real separation = 0);

}  // namespace tamis::oracle

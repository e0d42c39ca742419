// The oracle of moving bodies: asks for the first touch of each pair of their features by itself.
#pragma once
#include <vector>

#include "oracle/turning.hpp"
#include "tamis/mesh.hpp"

namespace tamis::oracle {

struct MovingBody {
  std::vector<Point> points;  ///< in its own frame
  std::vector<Face> faces;
  std::vector<Turning> links = {};        ///< outermost first; empty: the frame is the world's
  std::vector<Point> points_at_end = {};  ///< points go straight to these in the body's frame; empty: they stay
};

/// The first time at which the bodies are nearer than `separation` + 1e-15, as in apart_until; above 1: never.
Real first_touch(const MovingBody& first, const MovingBody& second, Real separation = 0);
/// The same for a body and itself: features with a common vertex do not count.
Real first_touch(const MovingBody& body, Real separation = 0);

}  // namespace tamis::oracle

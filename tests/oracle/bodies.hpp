// The oracle of moving bodies: the first touch of all pairs of their features, each by itself.
#pragma once
#include <vector>

#include "oracle/turning.hpp"
#include "tamis/mesh.hpp"

namespace tamis::oracle {

struct MovingBody {
  std::vector<Point> points;  ///< in its own frame
  std::vector<Face> faces;
  std::vector<Turning> links = {};        ///< outermost first; none: the frame is the world's
  std::vector<Point> points_at_end = {};  ///< each goes straight to there in its own frame; empty: all stay
};

/// The first time at which the bodies are nearer than `separation` and 1e-15, as apart_until; above 1: never.
Real first_touch(const MovingBody& first, const MovingBody& second, Real separation = 0);
/// Of a body with itself: of features without a common vertex.
Real first_touch(const MovingBody& body, Real separation = 0);

}  // namespace tamis::oracle

// A sheet bent into a U whose vertices move in a subspace: the example of subspace culling.
#pragma once
#include "scenes/scene.hpp"

namespace tamis::scenes {

/// x = X + U q at both ends of the step.
struct ReducedScene {
  Scene scene;
  std::vector<Point> rest;    ///< X
  Index modes = 0;            ///< columns of U
  std::vector<double> basis;  ///< U: of vertex v and axis a, row 3 v + a
  std::vector<double> q_start, q_end;
};

/// About `triangles` triangles (at least a few); |q| = `length` at both ends, each in a random direction, so that the
/// arms of the U, `kReducedArmGap` apart, meet if `length` is about twice this gap or more. The modes move no vertex by
/// more than |q|.
ReducedScene reduced_sheet(Index triangles, std::uint64_t seed, double length);

inline constexpr double kReducedArmGap = 0.15;

}  // namespace tamis::scenes

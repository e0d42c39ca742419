// A cloth that falls on a ball and over itself.
#pragma once
#include <vector>

#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis::bullet {

struct ClothRun {
  Mesh mesh;
  std::vector<std::vector<Point>> frames;  ///< steps + 1
  double milliseconds = 0;                 ///< processor time of a step
};

/// Simulates a square cloth of one metre with `side` vertices a side and Bullet's own self-collision, which falls on a
/// ball and a floor, in steps of 1/240 s. `truncated`: in a TruncatedWorld. REQUIRES: side >= 2, steps >= 1.
ClothRun run_cloth(int side, int steps, bool truncated);

/// The number of steps in which the cloth touches itself if all vertices go straight, by a Detector of its own.
int touching_steps(const ClothRun& run);

}  // namespace tamis::bullet

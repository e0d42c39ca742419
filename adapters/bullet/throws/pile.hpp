// A pile of plates so thin that gravity moves one through the next in two steps.
#pragma once
#include "adapters/bullet/throws/arena.hpp"

namespace tamis::bullet {

struct PileRun {
  std::vector<Triangles> bodies;  ///< the floor first, then the plates from below
  Places places;
  double milliseconds = 0;  ///< processor time of a step
  double questions = 0;     ///< that the clamp asks in a step; 0 without it
};

/// Square plates 1 m wide and 5 mm thick fall onto each other on a floor; at first each is `drop` metres above the
/// next. Steps of 1/60 s. REQUIRES: plates and steps >= 1, drop > 0.
PileRun run_pile(int plates, double drop, int steps, bool clamped);

/// The number of plates that end no higher than their thickness above the place of the one below.
int plates_inside(const PileRun& run);

}  // namespace tamis::bullet

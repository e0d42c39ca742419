// Step lengths on curves. The distance that a pair must keep counts as its separation: the time at which it is reached
// is found as with any other separation.
#pragma once
#include "motion/pair_kinds.hpp"
#include "narrow/kept_distance.hpp"
#include "query/pair_vertices.hpp"
#include "tamis/path.hpp"

namespace tamis {

/// Proven bounds of the distance that a pair must keep, D + F (distance at t=0 - D).
struct KeptSeparation {
  double low, high;
  bool is_near_separation;  ///< not proven farther apart than D at t=0
};
KeptSeparation kept_separation(const Path& path, PairKind kind, const PairVertices& vertices, const DistanceRule& rule);

}  // namespace tamis

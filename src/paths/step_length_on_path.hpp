// Step lengths on curves: what a pair must keep of its distance at t=0 is a separation, and when it is reached is asked
// as of any other.
#pragma once
#include "motion/pair_kinds.hpp"
#include "narrow/kept_distance.hpp"
#include "query/pair_vertices.hpp"
#include "tamis/path.hpp"

namespace tamis {

/// D + F (distance at t=0 - D), between proven bounds.
struct KeptSeparation {
  double low, high;
  bool may_start_within;  ///< D: not proven apart at t=0
};
KeptSeparation kept_separation(const Path& path, PairKind kind, const PairVertices& vertices, const DistanceRule& rule);

}  // namespace tamis

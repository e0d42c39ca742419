// One pair at rest: tells whether it is within a separation, and makes its NearPair. Doubles answer first, by the code
// that lanes run, then integers.
#pragma once
#include "pair/motion/make_motion.hpp"
#include "tamis/proximity.hpp"
#include "tamis/statistics.hpp"

namespace tamis {

/// True if the pair is within its separation at t=0, or beyond it by less than doubles can tell. REQUIRES: finite
/// coordinates, also at t=1, a finite separation >= 0. Counts in `decided_by` which arithmetic had the last word.
bool may_start_within(PairKind kind, const PairPoints& points, double separation, PrecisionCount& decided_by);

/// REQUIRES: finite coordinates, also at t=1.
NearPair near_pair(PairKind kind, const std::array<Index, 4>& vertices, const PairPoints& points);

/// The distance at t=0, as NearPair tells it. REQUIRES: finite coordinates, also at t=1.
inline double start_distance(PairKind kind, const PairPoints& points) { return near_pair(kind, {}, points).distance; }

}  // namespace tamis

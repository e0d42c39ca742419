// Step lengths: how long a pair keeps a fraction of its clearance at t=0. The clearance is the distance beyond the
// minimum separation. There are two proofs. The second begins where the first ends.
// - By speed. The clearance falls no faster than the corners of the two features move against each other.
// - By advancement. The fraction to keep is a separation. Advancement along axes finds when it is reached
//   (pair/narrow/first_within.hpp).
#pragma once
#include "pair/motion/make_motion.hpp"
#include "tamis/contact.hpp"
#include "tamis/statistics.hpp"

namespace tamis {

/// distance(t) - min_separation must stay >= fraction * (distance(0) - min_separation). REQUIRES: 0 < fraction < 1.
struct DistanceRule {
  double fraction;
  double min_separation;
  /// A pair that has no clearance at t=0 must not come back to its separation once it has left it.
  bool ignores_start = false;
};

/// A time in [0,1] until which the pair is proven to obey the rule. It is 0 only if the time underflows, or if the pair
/// has no clearance at t=0 and is not ignored. It searches no further than `until`. A result below `until` does not
/// depend on it, and is no less than 1 - 2^-18 times (1 - fraction) clearance / speed. `speed` is the largest length of
/// any velocity of a corner of the difference, rounded up by kVelocity. REQUIRES: finite coordinates.
double keeps_distance_until(PairKind kind, const PairPoints& points, const DistanceRule& rule, double until,
                            PrecisionCount& decided_by);

/// A time at which the pair is proven to have no more than the fraction left; 1 if no such time is known. REQUIRES:
/// `lower` in [0,1]. REQUIRES (not checked: history): as keeps_distance_until gave it.
double fraction_is_left_at(PairKind kind, const PairPoints& points, const DistanceRule& rule, double lower);

/// The distance of the features at t=0, between proven bounds, in the unit of the positions. REQUIRES: finite
/// coordinates, also at t=1.
struct DistanceBounds {
  double low, high;
};
DistanceBounds start_distance_bounds(PairKind kind, const PairPoints& points);

}  // namespace tamis

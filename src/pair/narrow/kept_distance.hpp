// Step lengths: how long a pair keeps a fraction of its distance at t=0. The distance that counts is the clearance: the
// distance beyond the minimum separation. Two proofs, the second where the first ends:
//   by speed        the clearance falls no faster than the corners of the two features move against each other;
//   by advancement  the fraction to be kept is a separation, and advancement along axes (pair/narrow/first_within.hpp)
//   finds
//                   when it is reached.
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

/// A time in [0,1] until which the pair is proven to obey the rule. 0 only if it has no clearance at t=0, and that is
/// not ignored (or the time underflows). It searches no further than `until`. A result below `until` does not depend on
/// it, and is no less than 1 - 2^-18 times (1 - fraction) clearance / speed. `speed` is the largest length of any
/// velocity of a corner of the difference, rounded up by kVelocity. REQUIRES: finite coordinates.
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

// The decision on one pair, cheap arithmetic first: slab clip, one or two certified crossings; beginnings of the step
// of a pair that goes far; subdivision in time, or with a separation advancement; double-double; integers. All engines
// hand the pairs they leave undecided to these functions, so that they return the same set of contacts.
#pragma once
#include "pair/motion/make_motion.hpp"
#include "tamis/pair.hpp"
#include "tamis/statistics.hpp"

namespace tamis {

/// Which contacts matter, times in [0,1].
struct OfInterest {
  double latest = 1;  ///< as in PairOptions
  /// A pair of which doubles cannot tell when it touches counts as free if it is free until then.
  double needed_until = 1;
};

/// What the pair does during the step. Counts in `decided_by` which arithmetic had the last word.
PairResult decide(const PairInStep& pair, PrecisionCount& decided_by, const OfInterest& times = {});

/// Recontact: does a pair that touches at t=0 touch again, after it has come apart? REQUIRES (not checked: exact): it
/// touches at t=0.
PairResult decide_recontact(const PairInStep& pair, PrecisionCount& decided_by);

}  // namespace tamis

// The decision on one pair, cheap arithmetic first. The order: slab clip, one or two certified crossings; beginnings of
// the step for a pair that goes far; subdivision in time, or with a separation advancement; double-double; integers.
// All engines hand their undecided pairs to these functions. So they return the same set of contacts.
#pragma once
#include "pair/motion/make_motion.hpp"
#include "tamis/pair.hpp"
#include "tamis/statistics.hpp"

namespace tamis {

/// Which contacts matter, times in [0,1].
struct OfInterest {
  double latest = 1;  ///< as in PairOptions
  /// If doubles cannot tell when a pair touches, it counts as free if it is free until this time.
  double needed_until = 1;
};

/// Decides the pair for the step. Counts in `decided_by` which arithmetic had the last word.
PairResult decide(const PairInStep& pair, PrecisionCount& decided_by, const OfInterest& times = {});

/// Recontact: whether a pair that touches at t=0 touches again after it has separated. REQUIRES (not checked: exact):
/// it touches at t=0.
PairResult decide_recontact(const PairInStep& pair, PrecisionCount& decided_by);

}  // namespace tamis

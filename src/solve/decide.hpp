// The decision on one pair, cheap arithmetic first: slab clip, certified roots by subdivision in time, then exact
// algebra, or what else the methods try.
// Every method ends here, so that all return the same set of contacts.
#pragma once
#include "motion/make_motion.hpp"
#include "tamis/pair.hpp"
#include "tamis/statistics.hpp"

namespace tamis {

/// Is this bracket of a certified contact good enough? Wider ones, and ones that leave open whether the pair touches at
/// t=0, are sharpened by exact algebra, where the guarantee is exact: where the coplanarity cubic is nearly flat,
/// doubles know its root to few digits.
inline bool is_sharp(double toi_lower, double toi_upper) {
  return toi_upper - toi_lower <= 1e-11 && (toi_lower > 0 || toi_upper == 0);
}

/// REQUIRES: finite coordinates. Counts in `decided_by` which arithmetic had the last word.
PairResult decide(PairKind kind, const PairPoints& points, const PairOptions& options, PrecisionCount& decided_by);

}  // namespace tamis

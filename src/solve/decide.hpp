// The decision on one pair, cheap arithmetic first: slab clip, certified roots by subdivision in time, the same in
// double-double, what else the methods try, exact algebra.
// Every method ends here, so that all return the same set of contacts.
#pragma once
#include "motion/make_motion.hpp"
#include "tamis/pair.hpp"
#include "tamis/statistics.hpp"

namespace tamis {

/// REQUIRES: finite coordinates. Counts in `decided_by` which arithmetic had the last word.
PairResult decide(PairKind kind, const PairPoints& points, const PairOptions& options, PrecisionCount& decided_by);

}  // namespace tamis

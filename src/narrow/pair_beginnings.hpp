// Pairs that move much farther than they and their gap are large: in the unit of the whole step rounding makes points
// of them, which may have met at once. So beginnings of the step are decided, each longer than the one before and in
// units of time and length of its own, until the features separate for good.
#pragma once
#include <optional>

#include "motion/decision.hpp"
#include "motion/make_motion.hpp"

namespace tamis {

/// What the pair does during the step, proven. Nothing where it does not go far, or doubles do not tell.
std::optional<Decision> decide_in_beginnings(const PairInStep& pair);

}  // namespace tamis

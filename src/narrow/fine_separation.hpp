// When a pair first comes within its separation, sharpened in double-double where doubles give too wide a bracket.
#pragma once
#include <optional>

#include "motion/decision.hpp"
#include "motion/make_motion.hpp"
#include "motion/time_clip.hpp"

namespace tamis {

/// Touches between neighbouring doubles: the pair is apart until the first, and within its separation at the second.
/// Nothing where double-double does not prove that. Costs some twelve thousand instructions. REQUIRES: sizes that
/// are finite; the pair is apart on [0, bracket.t_in); the bracket lies in [0,1].
std::optional<Decision> first_within_finely(const PairInStep& pair, const TimeInterval<double>& bracket);

}  // namespace tamis

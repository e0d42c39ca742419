// What doubles decide of one pair during a time: the slab clip, and in what that leaves a subdivision in time, or with
// a separation an advancement.
#pragma once
#include "motion/decision.hpp"
#include "motion/pair_kinds.hpp"
#include "motion/pair_motion.hpp"
#include "motion/time_clip.hpp"
#include "narrow/sharp_bracket.hpp"

namespace tamis {

/// The part of a time that the slab clip leaves; all of it where sizes are not finite.
TimeInterval<double> clipped(PairKind kind, const PairMotion<double>& m, const TimeInterval<double>& time);

/// Unsure where sizes are not finite. REQUIRES: a motion that is not restricted; `time` as clipped() leaves it.
/// REQUIRES (not checked: exact): the pair is apart outside it.
Decision decide_in_doubles(PairKind kind, const PairMotion<double>& m, const TimeInterval<double>& time);

inline bool is_sharp_answer(const Decision& d) { return d.is_free() || (d.touches() && is_sharp(d.lower, d.upper)); }

}  // namespace tamis

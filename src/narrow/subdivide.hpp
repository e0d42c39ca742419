// The pairs one crossing cannot decide: the step is cut in time, earliest part first, until each part is proven free,
// holds one certified crossing, or is too short to be decided in this arithmetic.
#pragma once
#include "motion/decision.hpp"
#include "motion/pair_motion.hpp"
#include "motion/time_clip.hpp"
#include "tamis/contact.hpp"

namespace tamis {

/// REQUIRES: `m` is the motion of the whole step, finite; `time` is a part of it; the kind can cross. REQUIRES (not
/// checked: exact): the pair is apart outside `time`.
Decision subdivide(PairKind kind, const PairMotion<double>& m, const TimeInterval<double>& time);

}  // namespace tamis

// Minimum separation: the time when two features first come within m.separation of each other. By advancement along
// separating axes. At a time still in question the closest points give an axis that turns with the pair. The times when
// this axis proves the pair apart are known in closed form (pair/narrow/advancement.hpp). The next time in question is
// their end: Newton's method on the distance, from the safe side (after conservative advancement, Mirtich 1996; Zhang,
// Lee, Kim 2006, whose bound on the speed needs many more steps). Here a single pair is followed to the end. Lanes have
// decided most pairs before, by the same steps (search/kernels/advance_lanes.hpp).
#pragma once
#include "pair/motion/decision.hpp"
#include "pair/motion/pair_motion.hpp"
#include "pair/motion/time_clip.hpp"

namespace tamis {

/// Decides the pair during `time`. If it `touches`, the distance at `upper` is certified to be within the separation.
/// REQUIRES: `m` is the motion of the whole step, finite; `time` is a part of the step. REQUIRES (not checked: exact):
/// the pair is apart outside `time`.
Decision first_within(PairKind kind, const PairMotion<double>& m, const TimeInterval<double>& time);

/// A time in [0,1] before which the pair is proven farther apart than its separation, as late as doubles can prove
/// within a few steps. It is no earlier than the time when the pair's clearance first falls to kAdvanceClearance of its
/// size (docs/numerics/steps.md, "Step lengths"). It searches no further than `until`. A result below `until` does not
/// depend on it. REQUIRES: the motion of the whole step, finite; `from` in [0,1], `until` <= 1. REQUIRES (not checked:
/// exact): the pair is apart before `from`.
double apart_until(PairKind kind, const PairMotion<double>& m, double from, double until);

}  // namespace tamis

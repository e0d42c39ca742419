// A pair that is within its separation at t=0, in doubles: does it stay so, or leave it and not come back? Whoever
// ignores what touches at the start asks this of each such pair; nearly all do one or the other.
#pragma once
#include "motion/pair_motion.hpp"

namespace tamis {

/// Proven: the times of the step at which the pair is within its separation are [0, t] for some t in [0,1]
/// (docs/numerics.md, "Ignored at the start"). False: it may be otherwise. REQUIRES: the motion of the whole step,
/// finite.
bool touches_until_it_leaves(PairKind kind, const PairMotion<double>& m);

}  // namespace tamis

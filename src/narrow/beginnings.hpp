// Features that go far for how large they are, and their gap, at the start: in the unit of the whole step they are
// points, which may have met at once. So they are asked about beginnings of the step, each longer than the one before
// and in a unit of time and length of its own, until they part for good.
#pragma once
#include <optional>

#include "motion/decision.hpp"
#include "motion/make_motion.hpp"

namespace tamis {

/// What the pair does during the step, proven. Nothing where it does not go far, or doubles do not tell. REQUIRES: `m`
/// is the motion of `points` with that separation, its sizes are finite.
std::optional<Decision> decide_in_beginnings(PairKind kind, const PairPoints& points, double separation,
                                             const PairMotion<double>& m);

}  // namespace tamis

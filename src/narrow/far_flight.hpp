// Features that fly a million times as far as they are large: to doubles of the whole step they are points, which may
// have met at its start. The beginning of the step, in its own unit of time and length, tells; after it the pair parts.
#pragma once
#include "motion/make_motion.hpp"

namespace tamis {

/// True only if proven: the pair stays farther apart than its separation. REQUIRES: `m` is the motion of `points` with
/// that separation, its sizes are finite.
bool flies_past(PairKind kind, const PairPoints& points, double separation, const PairMotion<double>& m);

}  // namespace tamis

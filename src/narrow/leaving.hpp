// A pair that is within its separation at t=0, in doubles: it stays so, or leaves it, and then it may come back. Asked
// of each such pair where pairs that touch at the start are ignored.
#pragma once
#include <optional>

#include "motion/decision.hpp"
#include "motion/pair_motion.hpp"

namespace tamis {

/// When is the pair within its separation again, after it has left it for the first time? Nothing where doubles cannot
/// tell when, or whether, it leaves (docs/numerics.md, "Ignored at the start"). REQUIRES: the motion of the whole step,
/// finite; a separation > 0.
std::optional<Decision> within_once_apart(PairKind kind, const PairMotion<double>& m);

}  // namespace tamis

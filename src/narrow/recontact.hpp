// Recontact: a pair that is within its separation at t=0 may leave it and come back. In doubles; asked of each such
// pair where contacts at the start are ignored.
#pragma once
#include <optional>

#include "motion/decision.hpp"
#include "motion/pair_motion.hpp"

namespace tamis {

/// Finds when the pair is first within its separation again after it has left it: free if it never leaves, or never
/// comes back. Nothing where doubles cannot tell when, or whether, it leaves (docs/numerics.md, "Ignored at the
/// start"). REQUIRES: the motion of the whole step, finite; a separation > 0.
std::optional<Decision> first_recontact_within(PairKind kind, const PairMotion<double>& m);

}  // namespace tamis

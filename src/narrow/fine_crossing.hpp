// A crossing that doubles leave undecided, in double-double: when a pair touches that is known to, and whether a pair
// touches that passes close to a border of its features. What exact algebra would answer, in a fraction of its time.
#pragma once
#include <optional>

#include "motion/decision.hpp"
#include "motion/make_motion.hpp"

namespace tamis {

/// Of a pair that touches by `coarse`: when it first does, between neighbouring doubles. Of one that is unsure there:
/// whether it touches where the four points are coplanar, and when; in structured meshes most vertices that come to
/// edges do so within rounding. Nothing where double-double proves neither, as where they touch exactly at a border.
/// REQUIRES: a kind that can cross, no separation, sizes that are finite; `coarse` is not free, its times lie in [0,1].
/// REQUIRES (not checked: exact): between these the pair touches, and not before; or, if `coarse` is unsure, it does
/// not touch outside of them.
std::optional<Decision> decide_crossing_finely(const PairInStep& pair, const Decision& coarse);

}  // namespace tamis

// What doubles leave undecided of pairs that are ordinary but for rounding, in double-double: when one touches that is
// known to touch, and whether one touches that crosses a border of its features or passes it by. What exact algebra
// would answer, in a fraction of its time; most of what doubles leave undecided is of these kinds.
#pragma once
#include <optional>

#include "motion/decision.hpp"
#include "motion/make_motion.hpp"
#include "motion/time_clip.hpp"

namespace tamis {

/// When a pair that touches by `coarse` does so first, between neighbouring doubles; of one that is unsure there,
/// whether it touches where the four points are coplanar, and when: of structured meshes most vertices that come to
/// edges do so within rounding. Nothing where double-double proves neither, as where they touch exactly at a border.
/// REQUIRES: a kind that can cross; `m` is the motion of `points`, its sizes are finite; `coarse` is not free, its
/// times lie in [0,1]. REQUIRES (not checked: exact): between these the pair touches, and not before; or, if `coarse`
/// is unsure, it does not touch outside of them.
std::optional<Decision> decide_crossing_finely(PairKind kind, const PairPoints& points, const PairMotion<double>& m,
                                               const Decision& coarse);

/// Touches, between neighbouring doubles, the pair being apart until the first, and within its separation at the
/// second; nothing where double-double does not prove that. Costs some twelve thousand instructions. REQUIRES: `m` is
/// the motion of `points` with that separation, its sizes are finite; the pair is apart on [0, bracket.t_in); the
/// bracket lies in [0,1].
std::optional<Decision> first_within_finely(PairKind kind, const PairPoints& points, double separation,
                                            const PairMotion<double>& m, const TimeInterval<double>& bracket);

}  // namespace tamis

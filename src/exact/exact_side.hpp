// On which side of the other feature is the first one just before a time? Decided in integers: bodies that touch
// exactly where doubles see no sign have a side all the same.
#pragma once
#include "motion/make_motion.hpp"
#include "tamis/contact.hpp"

namespace tamis {

/// The sign, along e x f (motion/pair_motion.hpp), of the first feature's place against the second's at `time`, and
/// where the four points are coplanar then, just before it; at t=0 as if the motion had gone on so before. 0: they are
/// coplanar throughout. REQUIRES: finite coordinates, `time` in [0,1], a kind that can cross.
int side_just_before(PairKind kind, const PairPoints& points, double time);

}  // namespace tamis

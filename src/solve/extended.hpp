// The stage between doubles and exact algebra: pairs that doubles leave unsure, in double-double.
#pragma once
#include "motion/make_motion.hpp"
#include "solve/subdivide.hpp"

namespace tamis {

/// REQUIRES: finite differences of positions; the pair is apart outside `time`.
Decision decide_in_extended(PairKind kind, const PairPoints& points, const TimeInterval<double>& time);

/// The bracket of a certified contact, which doubles know to a few units in the last place of the coplanarity cubic:
/// where that is nearly flat, brackets get wide. REQUIRES: the points are coplanar once in `bracket`, where they touch.
inline constexpr double kWideBracket = 1e-11;
TimeInterval<double> sharpened(PairKind kind, const PairPoints& points, const TimeInterval<double>& bracket);

}  // namespace tamis

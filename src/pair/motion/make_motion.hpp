// From the positions of four points to the scaled motion of the pair, for one pair at a time.
#pragma once
#include <array>
#include <optional>

#include "numbers/double_double.hpp"
#include "pair/motion/pair_motion.hpp"
#include "tamis/step.hpp"

namespace tamis {

/// Up to four points at t=0 and at t=1, in the order of Contact. vf: the point, then a, b, c. ee: a0, a1, b0, b1. ve:
/// the point, then a, b. vv: two points. Unused points are zero.
struct PairPoints {
  std::array<Point, 4> start, end;
};

/// The pair's motion and `separation`, given in the unit of the points, times a power of two. The power brings the
/// largest size into [1/2, 1). So no decision depends on the unit of length, and no difference overflows. REQUIRES: a
/// valid kind, finite coordinates, a separation >= 0, infinite where nothing bounds it.
PairMotion<double> make_motion(PairKind kind, const PairPoints& points, double separation = 0);

/// A pair and its motion. Keeps a reference to the points. REQUIRES: as make_motion.
struct PairInStep {
  PairInStep(PairKind k, const PairPoints& p, double s = 0)
      : kind(k), points(p), separation(s), motion(make_motion(k, p, s)) {}

  const PairKind kind;
  const PairPoints& points;
  const double separation;  ///< in the unit of the points
  const PairMotion<double> motion;
};

/// The same motion in double-double. No difference is rounded, and numbers that underflow are below `underflow`.
PairMotion<DoubleDouble> make_fine_motion(const PairInStep& pair);

/// The motion during the first `part` of the step, a power of two, mapped to [0,1] and scaled by its own size. As exact
/// as make_motion. Nothing if the motion is so small that underflow would count. REQUIRES: 0 < part <= 1.
std::optional<PairMotion<double>> make_beginning(const PairInStep& pair, double part);

bool is_finite(const PairPoints& points);

}  // namespace tamis

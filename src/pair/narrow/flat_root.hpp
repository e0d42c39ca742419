// Coplanarity that comes to zero and turns there, or lingers, before it has passed zero anywhere. This happens where
// all points of a scene come to one line or one point. Doubles know the sign of such a cubic on neither side of the
// root, and its slope nowhere near. So cutting the time ends at the root without a decision.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "pair/distance/turning_gap.hpp"
#include "pair/filters/ncf.hpp"
#include "pair/motion/polynomials.hpp"
#include "pair/narrow/crossing_root.hpp"

namespace tamis {

/// The times at which the cubic's slope is zero, the first one first; NaN or outside of the step where there is none.
inline std::array<double, 2> turning_times(const std::array<double, 4>& k) {
  const double a = k[1] - 3 * k[0], b = k[2] - k[1], c = 3 * k[3] - k[2];  // the slope: a s^2 + 2 b s t + c t^2
  const double square = a - 2 * b + c, half = b - a;
  const double root = half + std::copysign(std::sqrt(std::max(half * half - square * a, 0.0)), half);
  const double x = -root / square, y = -a / root;
  return {std::min(x, y), std::max(x, y)};
}

/// True if the cubic keeps the sign that it has at the first of these times, as far as doubles can tell, to the second.
inline bool keeps_sign_until(const std::array<double, 4>& cubic, const TimeInterval<double>& time, double unit) {
  const auto k = restrict_to(cubic, time.t_in, time.t_out);
  const double end = error_bounds::bound(error_bounds::kCoplanarityEnd, unit);
  const double middle = error_bounds::bound(error_bounds::kCoplanarityMiddle, unit);
  const double sign = k[0] < 0 ? -1 : 1;
  return sign * k[0] > end && sign * k[1] >= -middle && sign * k[2] >= -middle && sign * k[3] >= -end;
}

/// How far from a root at `t` where the cubic turns, or lingers, its size stays below `bound`.
inline double flat_reach(const std::array<double, 4>& k, double t, double bound) {
  const double cube = (k[3] - k[0]) + (k[1] - k[2]), square = 3 * k[0] - 2 * k[1] + k[2] + 3 * cube * t;
  return std::min(std::sqrt(bound / std::fabs(square)), std::cbrt(bound / std::fabs(cube)));
}

/// True if integers must decide this pair. Doubles see its coplanarity come to such a root first, and neither NCF nor
/// an axis proves the pair apart there. True is never wrong: integers decide every pair. REQUIRES: the motion of the
/// whole step, finite.
template <PairKind kind>
bool comes_to_flat_root(const PairMotion<double>& m, const TimeInterval<double>& time) {
  constexpr double kNear = 0x1p-40, kPart = 0.5;
  const auto cubic = coplanarity_polynomial(m);
  const double unit = m.size_d * m.size_e * m.size_f;
  const double bound = error_bounds::bound(error_bounds::kCoplanarityEnd, unit);
  for (const double turn : turning_times(cubic)) {
    const double t = std::clamp(turn, time.t_in, time.t_out);
    if (!(std::fabs(turn - t) <= kNear && std::fabs(crossing::value(cubic, t)) <= bound)) continue;
    if (!keeps_sign_until(cubic, {time.t_in, t}, unit)) return false;
    const double reach = kPart * flat_reach(cubic, t, bound);
    const TimeInterval<double> part{std::max(t - reach, time.t_in), std::min(t + reach, time.t_out)};
    return !Ncf::proves_free<kind>(restrict_to(m, part.t_in, part.t_out)) &&
           !TurningGap<kind, double>(m).stays_apart(part, kTurningGapParts);
  }
  return false;
}

}  // namespace tamis

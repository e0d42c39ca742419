// When does an axis of any direction keep a pair apart? The slab clip on one axis chosen for the pair: sharper than a
// bound on its speed, because it knows how fast the two features close in along that axis, corner by corner.
#pragma once
#include <array>
#include <cmath>

#include "motion/pair_motion.hpp"
#include "numerics/error_bounds.hpp"

namespace tamis {

/// An open interval of time; empty if to <= from. All of the step: from below 0 to beyond 1.
struct ApartTimes {
  double from, to;
  bool contains(double t) const { return from < t && t < to; }
};

/// The Minkowski difference of the two features is the convex hull of these: their distance is its distance from zero.
template <PairKind kind>
inline auto difference_corners(const PairMotion<double>& m) {
  if constexpr (kind == PairKind::vertex_face)
    return std::array{m.d, m.d - m.e, m.d - m.f};
  else
    return std::array{m.d, m.d - m.e, m.d + m.f, m.d + m.f - m.e};
}

/// REQUIRES: `m` is the motion of the whole step, its sizes are finite.
template <PairKind kind>
class AxisClip {
 public:
  explicit AxisClip(const PairMotion<double>& m)
      : corners_(difference_corners<kind>(m)),
        separation_(m.separation * (1 + 4 * kRoundoff)),
        error_(error_bounds::bound(error_bounds::kCornerProjection, m.size_d + m.size_e + m.size_f)) {}

  /// Times at which, proven, all corners lie beyond the separation along `axis`, which may have any length.
  ApartTimes along(const Vec3<double>& axis) const {
    const double inverse_size = 1 / max(max(abs(axis.x), abs(axis.y)), abs(axis.z));
    const Vec3<double> n = inverse_size * axis;
    const double length = std::sqrt(dot(n, n)) * (1 + error_bounds::kLength * kRoundoff);
    const double threshold = separation_ * length + error_;
    ApartTimes times{-1, 2};
    for (const auto& corner : corners_) cut(times, dot(n, corner.at0) - threshold, dot(n, corner.at1) - threshold);
    return times;
  }

 private:
  static constexpr double kRoundoff = error_bounds::unit_roundoff<double>;

  /// Leaves the times at which the line from g0 (t=0) to g1 (t=1) is positive; none where either is NaN. The root is
  /// off, of itself, by 2 u for the two ends, u for their difference and u for the quotient; 8 u are given.
  static void cut(ApartTimes& times, double g0, double g1) {
    if (g0 > 0 && g1 > 0) return;
    const double root = g0 / (g0 - g1);
    if (g0 > 0 && g1 <= 0)
      times.to = min(times.to, root * (1 - 8 * kRoundoff));
    else if (g0 <= 0 && g1 > 0)
      times.from = max(times.from, root * (1 + 8 * kRoundoff));
    else
      times = {2, -1};
  }

  decltype(difference_corners<kind>(PairMotion<double>{})) corners_;
  double separation_, error_;
};

}  // namespace tamis

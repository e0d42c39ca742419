// Swept discrete oriented polytope: the range of a moving feature on each of some constant axes, over the whole step.
#pragma once
#include <algorithm>
#include <array>
#include <limits>

#include "numbers/assert.hpp"
#include "numbers/axes.hpp"
#include "pair/motion/pair_motion.hpp"
#include "paper/bounds/moving_points.hpp"

namespace tamis::lab {

/// 2 `axes` half-spaces, kept in float and rounded outward, so that they contain the feature.
template <std::size_t axes>
struct KDop {
  std::array<float, axes> lower, upper;

  /// Around a moving point, blown up by a Euclidean distance of `padding`, relative to `origin`.
  /// REQUIRES: coordinates of MovingPoints, which floats can hold.
  static KDop around(const Moving<double>& point, const Vec3<double>& origin, double padding) {
    TAMIS_ASSERT(largest(point) < kLargestScaled);
    const Vec3<double> p0 = point.at0 - origin, p1 = point.at1 - origin;
    const double size = std::max(norm1(p0), norm1(p1)) + padding;
    // Rounding: subtracting the origin and projecting, less than 8 * 2^-53 size; converting to float, 2^-24 size;
    // adding this margin, 2^-24 (size + margin). Together below 2^-22 size; the last term covers underflow.
    const float margin = static_cast<float>(size) * 0x1p-22F + std::numeric_limits<float>::min();
    KDop box;
    for_each_axis<axes>([&](auto i) {
      const double s0 = project<i()>(p0), s1 = project<i()>(p1), blow_up = padding * axis_length(i());
      box.lower[i()] = static_cast<float>(std::min(s0, s1) - blow_up) - margin;
      box.upper[i()] = static_cast<float>(std::max(s0, s1) + blow_up) + margin;
    });
    return box;
  }

  /// Sum of the extents: a measure of size that survives flat boxes.
  double extent() const {
    double sum = 0;
    for (std::size_t i = 0; i < axes; ++i) sum += static_cast<double>(upper[i]) - static_cast<double>(lower[i]);
    return sum;
  }

 private:
  static double norm1(const Vec3<double>& v) { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); }
};

template <std::size_t axes>
inline KDop<axes> merge(const KDop<axes>& a, const KDop<axes>& b) {
  KDop<axes> box;
  for (std::size_t i = 0; i < axes; ++i) box.lower[i] = b.lower[i] < a.lower[i] ? b.lower[i] : a.lower[i];
  for (std::size_t i = 0; i < axes; ++i) box.upper[i] = a.upper[i] < b.upper[i] ? b.upper[i] : a.upper[i];
  return box;
}

/// Returns false if the two are apart during the whole step. Without branches, to compile to a few SIMD comparisons.
template <std::size_t axes>
inline bool overlap(const KDop<axes>& a, const KDop<axes>& b) {
  unsigned apart = 0;
  for (std::size_t i = 0; i < axes; ++i) apart |= unsigned(a.lower[i] > b.upper[i]) | unsigned(b.lower[i] > a.upper[i]);
  return apart == 0;
}

using Aabb = KDop<3>;
using Dop16 = KDop<8>;
using Dop18 = KDop<9>;
using Dop26 = KDop<13>;

}  // namespace tamis::lab

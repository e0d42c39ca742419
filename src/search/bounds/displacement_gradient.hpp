// The displacement gradient: u(x) = c + G x + residual(x). At t the vector between two points is (I + t G) (y - x) + t
// (residual(y) - residual(x)). So a motion that turns or stretches the whole has no residual. Distances shrink by the
// least principal stretch of I + t G at most.
#pragma once
#include <array>
#include <span>

#include "numbers/vec.hpp"
#include "search/bounds/packed_motion.hpp"

namespace tamis {

struct SymmetricMatrix {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;

  void add_square(const Vec3<double>& v, double weight = 1) {
    const Vec3<double> w = weight * v;
    xx += w.x * v.x;
    yy += w.y * v.y;
    zz += w.z * v.z;
    xy += w.x * v.y;
    xz += w.x * v.z;
    yz += w.y * v.z;
  }
};

struct DisplacementGradient {
  std::array<Vec3<double>, 3> rows{};  ///< zero: nothing in common

  Vec3<double> at(const Vec3<double>& x) const { return {dot(rows[0], x), dot(rows[1], x), dot(rows[2], x)}; }
};

/// Proven for all x and all t in [0,1]: least |x| <= |(I + t G) x| <= greatest |x|.
struct StretchBounds {
  double least = 1, greatest = 1;
};

StretchBounds stretch_bounds(const DisplacementGradient& gradient);

/// Any gradient is valid, together with its residuals. So nothing is proven here, and NaN is an answer.
struct GradientFit {
  DisplacementGradient gradient;
  Vec3<double> mean_position{}, mean_displacement{};  ///< positions at t=0
};

/// The gradient by least squares over every `stride`-th of the vertices but outliers, in the frame of the boxes.
GradientFit fit_gradient(const PackedMotion& motion, std::span<const Index> vertices, std::size_t stride);

}  // namespace tamis

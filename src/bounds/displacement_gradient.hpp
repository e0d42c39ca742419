// What displacements have in common beyond a translation: u(x) = c + G x + rest(x). At t two points are apart by
// (I + t G) (y - x) + t (rest(y) - rest(x)), so what turns or stretches as a whole has no rest, and its distances
// shrink by the least principal stretch of I + t G at most.
#pragma once
#include <array>
#include <span>

#include "bounds/packed_motion.hpp"

namespace tamis {

struct DisplacementGradient {
  std::array<Vec3<double>, 3> rows{};  ///< zero: nothing in common

  Vec3<double> at(const Vec3<double>& x) const { return {dot(rows[0], x), dot(rows[1], x), dot(rows[2], x)}; }
};

/// Proven for all x and all t in [0,1]: least |x| <= |(I + t G) x| <= greatest |x|.
struct StretchBounds {
  double least = 1, greatest = 1;
};

StretchBounds stretch_bounds(const DisplacementGradient& gradient);

/// The gradient of least squares, and what of the displacements it explains. Any gradient is a true one, with its
/// rests; so nothing is proven here, and NaN is an answer.
struct GradientFit {
  DisplacementGradient gradient;
  Vec3<double> middle{}, way{};  ///< means of places at t=0, and of displacements
  /// Means of the squares of displacements, and of rests, without what translation explains.
  double displacement2 = 0, rest2 = 0;
};

/// In the frame of the boxes, of up to a thousand of the vertices.
GradientFit fit_gradient(const Step& step, const BoxFrame& frame, std::span<const Index> vertices);

}  // namespace tamis

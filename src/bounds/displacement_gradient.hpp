// What displacements have in common beyond a translation: u(x) = c + G x + residual(x). At t two points are apart by
// (I + t G) (y - x) + t (residual(y) - residual(x)), so what turns or stretches as a whole has no residual, and its
// distances shrink by the least principal stretch of I + t G at most.
#pragma once
#include <array>
#include <span>

#include "bounds/packed_motion.hpp"
#include "bounds/symmetric_axes.hpp"

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
/// residuals; so nothing is proven here, and NaN is an answer.
struct GradientFit {
  DisplacementGradient gradient;
  Vec3<double> middle{}, way{};  ///< means of places at t=0, and of displacements
  /// Sums of the squares of displacements, and of residuals, without what translation explains.
  double displacement2 = 0, residual2 = 0;
};

/// What a fit needs to know of some vertices; that of two sets together is the sum of theirs.
class DisplacementMoments {
 public:
  /// Of one vertex that stands for `count`, in the frame of the boxes.
  void add(const Vec3<double>& place, const Vec3<double>& way, double count);
  DisplacementMoments& operator+=(const DisplacementMoments& other);

  double count() const { return count_; }
  /// What GradientFit has of that name.
  double displacement2() const;
  GradientFit fit() const;

 private:
  double count_ = 0;
  Vec3<double> place_{}, way_{};
  SymmetricMatrix place2_;
  std::array<Vec3<double>, 3> way_place_{};  ///< [i]: way[i] times place
  double way2_ = 0;
};

/// Of every `stride`-th of the vertices, from the first on; each stands for as many as there are for one of them.
DisplacementMoments moments_of(const Step& step, const BoxFrame& frame, std::span<const Index> vertices,
                               std::size_t stride);

}  // namespace tamis

// Contour tests: is the boundary of a patch of surface, projected along an axis, free of self-intersection during the
// whole step? If all normals of the patch stay within less than a right angle of the axis, and the sum of its
// triangles' oriented boundaries is that contour and nothing else, then the patch is free of self-contact: a generic
// point of the plane is covered as often as the contour winds around it, which is once or never (degree of a map).
// Neither manifoldness nor a disc is needed for that.
#pragma once
#include <span>
#include <vector>

#include "pair/motion/pair_motion.hpp"

namespace tamis::lab {

struct Moving2 {
  std::array<double, 2> at0, at1;
};

/// A closed moving polygon in the plane, relative to the mean of its points.
class ProjectedContour {
 public:
  /// Projects along the unit vector `axis`, up to rounding. REQUIRES: at least three points.
  void project(std::span<const Moving<double>> loop, const Vec3<double>& axis);

  /// Proves that the mean sees every edge turn the same way, once around (star contours: Schvartzman, Gascon, Otaduy
  /// 2010, for the whole step at once). Linear in the points.
  bool proves_star_shaped() const;

  /// Proves that no two edges touch, but for neighbours at their common point. Quadratic in the points.
  bool proves_simple() const;

 private:
  bool neighbours_stay_unfolded(std::size_t edge) const;
  bool edges_stay_apart(std::size_t i, std::size_t j) const;

  std::vector<Moving2> points_;
  double error_ = 0;  ///< bounds the error of a coefficient of a cross or dot product of two differences
  double slack_ = 0;  ///< bounds the error of a difference
};

}  // namespace tamis::lab

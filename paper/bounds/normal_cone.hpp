// Continuous normal cone (Volino, Magnenat-Thalmann 1994; Tang, Curtis, Yoon, Manocha 2009): contains the directions of
// the normals of moving triangles over the whole step.
#pragma once
#include <array>

#include "pair/motion/pair_motion.hpp"

namespace tamis::lab {

/// Directions within `half_angle` of the unit vector `axis`; everything if half_angle >= pi.
struct NormalCone {
  Vec3<double> axis{0, 0, 1};
  double half_angle;

  /// Every construction and merge adds this to the angle. Far above the angle's rounding (double precision, and acos
  /// near 0 and pi, where it is off by about 1e-8).
  static constexpr double kMargin = 1e-6;

  /// Of the triangle a b c. Everything if it may lose its area during the step.
  static NormalCone around(const Moving<double>& a, const Moving<double>& b, const Moving<double>& c);

  double extent() const { return half_angle; }
};

NormalCone merge(const NormalCone& a, const NormalCone& b);

}  // namespace tamis::lab

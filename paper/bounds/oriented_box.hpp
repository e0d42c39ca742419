// Swept oriented box (OBB: Gottschalk, Lin, Manocha 1996), fitted by the covariance of the corners it bounds.
#pragma once
#include <array>
#include <span>

#include "pair/motion/pair_motion.hpp"

namespace tamis::lab {

/// The points p with |axes[i].(p - centre)| <= half[i]. The axes are orthonormal up to rounding: errors below
/// kSkew a component, which every certificate allows for.
struct OrientedBox {
  static constexpr double kSkew = 0x1p-48;

  Vec3<double> centre;
  std::array<Vec3<double>, 3> axes;
  std::array<double, 3> half;

  /// REQUIRES: one to three moving points.
  static OrientedBox around(std::span<const Moving<double>> points, const Vec3<double>& origin, double padding);

  double extent() const { return half[0] + half[1] + half[2]; }
};

OrientedBox merge(const OrientedBox& a, const OrientedBox& b);

/// Separating axes: the faces' normals and the cross products of the edges, fifteen in all.
bool overlap(const OrientedBox& a, const OrientedBox& b);

}  // namespace tamis::lab

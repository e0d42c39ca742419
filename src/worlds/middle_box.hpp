// Boxes by their middles, in the frames of bodies, and vectors of doubles.
#pragma once
#include <array>
#include <cmath>

#include "curves/motions/chain_motion.hpp"
#include "search/bounds/box.hpp"
#include "search/topology/points.hpp"

namespace tamis {

using Triangle = std::array<Point, 3>;

inline Point cross_of(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Point column(const RoundedTransform& place, std::size_t k) {
  return {place.rows[0][k], place.rows[1][k], place.rows[2][k]};
}

/// A node's box in the frame of its body, by its middle.
struct MiddleBox {
  Point middle, half;
  double radius;  ///< of a ball around the middle
  double reach;   ///< no point is farther from the origin of the frame

  explicit MiddleBox(const Box& box) : middle(box.middle()) {
    double square = 0, far = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      half[k] = std::max(box.high[k] - middle[k], middle[k] - box.low[k]);
      const double farthest = std::max(std::fabs(box.low[k]), std::fabs(box.high[k]));
      square += half[k] * half[k];
      far += farthest * farthest;
    }
    radius = std::sqrt(square) * kRoundedUp;
    reach = std::sqrt(far) * kRoundedUp + 0x1p-500;
  }
  /// How far it reaches along a direction from its middle, at a place.
  double extent(const RoundedTransform& place, const Point& direction) const {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += half[k] * std::fabs(dot(column(place, k), direction));
    return sum;
  }
};

}  // namespace tamis

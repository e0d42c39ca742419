// Directions along which two convex sets are apart: boxes of bodies' frames, and triangles. A direction is found in
// doubles, by any means. Only the gap along it is certified.
#pragma once
#include <array>
#include <optional>

#include "worlds/edge_motion.hpp"

namespace tamis {

inline double dot_of(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point difference(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
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
    for (std::size_t k = 0; k < 3; ++k) sum += half[k] * std::fabs(dot_of(column(place, k), direction));
    return sum;
  }
};

/// A direction from one set towards the other, of length 1 but for rounding, and the gap along it.
struct Gap {
  Point direction;
  double width;  ///< not certified
};

/// The widest gap of two boxes along the 15 directions of their edges, faces and pairs of edges (Gottschalk, Lin,
/// Manocha 1996). Negative if there is none.
Gap gap_of(const MiddleBox& a, const RoundedTransform& at_a, const MiddleBox& b, const RoundedTransform& at_b);

using Triangle = std::array<Point, 3>;

/// A gap of two triangles. Points of both are projected onto the other in turn, which leads to the closest points where
/// they are apart (von Neumann). If that leaves no gap, directions of edges and faces are tried, as of boxes.
Gap gap_of(const Triangle& a, const Triangle& b);

/// The width along a direction.
double width_along(const Point& direction, const Triangle& a, const Triangle& b);

/// True only if an edge of one triangle surely passes through the other. No corner is off by more than `error` along
/// any direction.
bool surely_meet(const Triangle& a, const Triangle& b, double error);

}  // namespace tamis

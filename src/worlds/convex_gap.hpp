// Directions along which two convex sets are apart: boxes of bodies' frames, and triangles. A direction is found in
// doubles, by any means. Only the gap along it is certified.
#pragma once
#include <array>
#include <optional>

#include "worlds/edge_motion.hpp"

namespace tamis {

/// A direction from one set towards the other, of length 1 but for rounding, and the gap along it.
struct Gap {
  Point direction;
  double width;  ///< not certified
};

/// The widest gap of two boxes along the 15 directions of their edges, faces and pairs of edges (Gottschalk, Lin,
/// Manocha 1996). Negative if there is none.
Gap gap_of(const MiddleBox& a, const RoundedTransform& at_a, const MiddleBox& b, const RoundedTransform& at_b);

/// A gap of two triangles. Points of both are projected onto the other in turn, which leads to the closest points where
/// they are apart (von Neumann). If that leaves no gap, directions of edges and faces are tried, as of boxes.
Gap gap_of(const Triangle& a, const Triangle& b);

/// The width along a direction.
double width_along(const Point& direction, const Triangle& a, const Triangle& b);

/// True only if an edge of one triangle surely passes through the other. No corner is off by more than `error` along
/// any direction.
bool surely_meet(const Triangle& a, const Triangle& b, double error);

}  // namespace tamis

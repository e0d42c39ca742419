// All kinds of pair as one question: whether a moving convex polygon contains the origin.
//   vertex-face: the triangle p-a, p-b, p-c;   edge-edge: the parallelogram b0-a0, b0-a1, b1-a1, b1-a0
//   vertex-edge: the segment p-a, p-b;         vertex-vertex: the point p-q
// (the Minkowski difference of the two features; the last two are polygons without area). Coordinates are integers,
// exact multiples of the inputs, or estimates of those.
#pragma once
#include <array>
#include <cstddef>

#include "numbers/dyadic_cell.hpp"
#include "numbers/estimate.hpp"
#include "pair/motion/make_motion.hpp"
#include "pair/motion/polynomials.hpp"

namespace tamis {

/// Corner: a vector, or a moving one.
template <class Corner>
struct PolygonOf {
  std::array<Corner, 4> corners;  ///< in order around it
  std::size_t corner_count;       ///< 1 to 4
  int exponent;                   ///< a coordinate 1 is a length of 2^exponent

  /// Corner corner_count is the first one again. REQUIRES: i <= corner_count.
  const Corner& corner(std::size_t i) const {
    TAMIS_ASSERT(i <= corner_count);
    return corners[i < corner_count ? i : 0];
  }
  /// Side i leads from corner i to corner i + 1. A point has one too, from itself to itself.
  std::size_t side_count() const { return corner_count == 2 ? 1 : corner_count; }
};
using MovingPolygon = PolygonOf<Moving<Integer>>;
/// The polygon at one time.
template <class Number>
using Polygon = PolygonOf<Vec3<Number>>;

/// The difference polygon times a power of two that makes its coordinates and the separation integers. REQUIRES: finite
/// numbers, a kind there is.
MovingPolygon difference_polygon(PairKind kind, const PairPoints& points, double separation = 0);

/// The same at t=0, in the unit that the start alone needs. This makes numbers shorter. REQUIRES: as above.
template <class Number = Integer>
Polygon<Number> start_polygon(PairKind kind, const PairPoints& points, double separation = 0);

/// The displacement of each corner during the step, in a unit of its own. REQUIRES: as above.
template <class Number>
Polygon<Number> corner_velocities(PairKind kind, const PairPoints& points);

/// As difference_polygon, with each axis times a power of two of its own. Numbers are shorter and times of touching the
/// same, but there are no distances. The exponent means nothing. REQUIRES: as above.
MovingPolygon stretched_polygon(PairKind kind, const PairPoints& points);

/// The polygon at `time` of the step, the lower end of that cell. REQUIRES (not checked: exact): `time` is in [0,1].
Polygon<Integer> polygon_at(const MovingPolygon& polygon, const DyadicCell& time);

/// The normal of the polygon's plane, as pair/motion/polynomials.hpp has it. Zero if there are less than three corners.
inline std::array<Vec3<Integer>, 3> normal_polynomial(const MovingPolygon& polygon) {
  const Moving<Integer>& first = polygon.corner(0);
  return normal_polynomial(polygon.corner(1) - first, polygon.corner(polygon.corner_count - 1) - first);
}

/// x / 2^exponent. REQUIRES: x is finite, and the quotient is an integer.
template <class Number = Integer>
Number scaled_to_integer(double x, int exponent);

}  // namespace tamis

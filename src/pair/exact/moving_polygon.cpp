#include "pair/exact/moving_polygon.hpp"

#include <cmath>

#include "numbers/assert.hpp"
#include "pair/exact/units.hpp"
#include "pair/motion/pair_kinds.hpp"

namespace tamis {
namespace {

template <class Number>
Vec3<Number> scaled_to_integers(const Point& p, const Exponents& units) {
  return {scaled_to_integer<Number>(p[0], units[0]), scaled_to_integer<Number>(p[1], units[1]),
          scaled_to_integer<Number>(p[2], units[2])};
}

/// The difference polygon of a pair whose features have the vertices `x`.
template <class Corner>
PolygonOf<Corner> polygon_of(PairKind kind, const std::array<Corner, 4>& x, int exponent) {
  const auto corners = difference_corners(kind);
  PolygonOf<Corner> polygon{{}, corners.size(), exponent};
  for (std::size_t i = 0; i < corners.size(); ++i) polygon.corners[i] = x[corners[i].to] - x[corners[i].from];
  return polygon;
}

MovingPolygon moving_polygon(PairKind kind, const PairPoints& points, const Exponents& units) {
  const auto at = [&](std::size_t i) {
    return Moving<Integer>{scaled_to_integers<Integer>(points.start[i], units),
                           scaled_to_integers<Integer>(points.end[i], units)};
  };
  return polygon_of<Moving<Integer>>(kind, {at(0), at(1), at(2), at(3)}, units[0]);
}

}  // namespace

template <class Number>
Number scaled_to_integer(double x, int exponent) {
  if (x == 0) return 0;
  const Parts parts = parts_of(x);
  TAMIS_ASSERT(std::isfinite(x) && lowest_exponent(x) >= exponent);
  return Number::scaled(parts.mantissa, parts.exponent - exponent);
}
template Integer scaled_to_integer(double, int);
template Estimate scaled_to_integer(double, int);

MovingPolygon difference_polygon(PairKind kind, const PairPoints& points, double separation) {
  TAMIS_ASSERT(is_kind(kind) && is_finite(points) && std::isfinite(separation));
  return moving_polygon(kind, points, common_unit(lowest_exponents(points), separation));
}

MovingPolygon stretched_polygon(PairKind kind, const PairPoints& points) {
  TAMIS_ASSERT(is_kind(kind) && is_finite(points));
  return moving_polygon(kind, points, lowest_exponents(points));
}

template <class Number>
Polygon<Number> start_polygon(PairKind kind, const PairPoints& points, double separation) {
  TAMIS_ASSERT(is_kind(kind) && is_finite(points) && std::isfinite(separation));
  const Exponents units = common_unit(lowest_exponents(points.start), separation);
  const auto at = [&](std::size_t i) { return scaled_to_integers<Number>(points.start[i], units); };
  return polygon_of<Vec3<Number>>(kind, {at(0), at(1), at(2), at(3)}, units[0]);
}
template Polygon<Integer> start_polygon(PairKind, const PairPoints&, double);
template Polygon<Estimate> start_polygon(PairKind, const PairPoints&, double);

template <class Number>
Polygon<Number> corner_velocities(PairKind kind, const PairPoints& points) {
  TAMIS_ASSERT(is_kind(kind) && is_finite(points));
  const auto &start = points.start, &end = points.end;
  const Exponents units = common_unit(lowest_exponents(points), 0);
  const auto of = [&](std::size_t i) {
    return scaled_to_integers<Number>(end[i], units) - scaled_to_integers<Number>(start[i], units);
  };
  return polygon_of<Vec3<Number>>(kind, {of(0), of(1), of(2), of(3)}, units[0]);
}
template Polygon<Integer> corner_velocities(PairKind, const PairPoints&);
template Polygon<Estimate> corner_velocities(PairKind, const PairPoints&);

Polygon<Integer> polygon_at(const MovingPolygon& polygon, const DyadicCell& time) {
  const Integer before = (Integer(1) << time.k) - time.n;
  Polygon<Integer> at{{}, polygon.corner_count, polygon.exponent - time.k};
  for (std::size_t i = 0; i < polygon.corner_count; ++i)
    at.corners[i] = before * polygon.corners[i].at0 + time.n * polygon.corners[i].at1;
  return at;
}

}  // namespace tamis

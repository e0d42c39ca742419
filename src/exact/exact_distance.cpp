#include "exact/exact_distance.hpp"

#include <algorithm>
#include <optional>

#include "distance/rest_distance.hpp"

namespace tamis {
namespace {

using IntegerVec = Vec3<Integer>;
using Plane = NearestPoint::Plane;

bool is_smaller(const Fraction& a, const Fraction& b) {
  TAMIS_ASSERT(a.below.sign() > 0 && b.below.sign() > 0);
  return (a.above * b.below - b.above * a.below).sign() < 0;
}

struct OnSide {
  Fraction square, along;
};

/// Of the segment from corner x to corner y.
OnSide nearest_on_side(const IntegerVec& x, const IntegerVec& y) {
  const IntegerVec side = y - x;
  const Integer before = dot(x, side);
  if (before.sign() >= 0) return {{dot(x, x)}, {0}};
  const Integer length2 = dot(side, side);
  if ((before + length2).sign() <= 0) return {{dot(y, y)}, {1}};                  // y.side
  return {{dot(x, x) * length2 - before * before, length2}, {-before, length2}};  // |x cross y|^2 (Lagrange)
}

const IntegerVec& corner(const MovingPolygon& polygon, std::size_t i) { return polygon.corner(i).at0; }

IntegerVec normal_of(const MovingPolygon& polygon) {
  const IntegerVec& first = corner(polygon, 0);
  return cross(corner(polygon, 1) - first, corner(polygon, polygon.corner_count - 1) - first);
}

Vec3<double> unit_vector_of(const IntegerVec& v) {
  const WideDouble x = WideDouble::of(v.x), y = WideDouble::of(v.y), z = WideDouble::of(v.z);
  const long largest = std::max({x.exponent, y.exponent, z.exponent});  // an integer's is positive, but that of zero
  if (largest == 0) return {0, 0, 0};
  const auto value = [&](const WideDouble& a) { return a.times_two_to(-largest).value(); };
  return unit_vector(Vec3<double>{value(x), value(y), value(z)});
}

struct Weights {
  double u, v;
};

/// Of the polygon's corners.
Weights corner_weights(PairKind kind, std::size_t i) {
  constexpr Weights kFace[] = {{0, 0}, {1, 0}, {0, 1}}, kEdges[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  return kind == PairKind::edge_edge ? kEdges[i] : kFace[i];
}

/// Of the point from corner i to corner j, at that time.
IntegerVec at_weight(const IntegerVec& i, const IntegerVec& j, const Fraction& along) {
  TAMIS_ASSERT(along.below.sign() > 0);
  return along.below * i + along.above * (j - i);
}

IntegerVec velocity(const MovingPolygon& moving, std::size_t i) { return moving.corner(i).at1 - moving.corner(i).at0; }

/// The gap's direction; where there is none, that which it had before: against its velocity, as far as the side does
/// not take part in that.
Vec3<double> direction_on_side(const MovingPolygon& polygon, const MovingPolygon& moving, const NearestPoint& nearest) {
  const std::size_t i = nearest.side, j = i + 1;
  const IntegerVec gap = at_weight(corner(polygon, i), corner(polygon, j), nearest.along);
  if (dot(gap, gap).sign() > 0) return unit_vector_of(gap);
  const IntegerVec came = -at_weight(velocity(moving, i), velocity(moving, j), nearest.along);
  const bool is_corner = nearest.along.above.sign() == 0 || (nearest.along.below - nearest.along.above).sign() == 0;
  if (is_corner) return unit_vector_of(came);
  const IntegerVec side = corner(polygon, j) - corner(polygon, i);
  return unit_vector_of(dot(side, side) * came - dot(came, side) * side);
}

ExactDistance on_side(PairKind kind, const MovingPolygon& polygon, const MovingPolygon& moving,
                      const NearestPoint& nearest) {
  const std::size_t i = nearest.side, j = (i + 1) % polygon.corner_count;
  const double s = wide(nearest.along).value();
  const Weights a = corner_weights(kind, i), b = corner_weights(kind, j);
  const auto mixed = [&](double from, double to) { return from == to ? from : to > from ? s : 1 - s; };
  return {0, mixed(a.u, b.u), mixed(a.v, b.v), direction_on_side(polygon, moving, nearest)};
}

ExactDistance inside(const MovingPolygon& moving, const Plane& plane) {
  const std::size_t end = moving.corner_count - 1;
  const IntegerVec& normal = plane.normal;
  const Integer &square = plane.square, &u = plane.within[end], &v = plane.within[0];
  const auto height_of_velocity = [&] {
    const IntegerVec v0 = velocity(moving, 0);
    return dot(normal, square * v0 + u * (velocity(moving, 1) - v0) + v * (velocity(moving, end) - v0));
  };
  const int height = plane.height.sign();
  const bool is_behind = height != 0 ? height < 0 : height_of_velocity().sign() > 0;
  const Vec3<double> direction = unit_vector_of(normal);
  return {0, wide({u, square}).value(), wide({v, square}).value(), is_behind ? -direction : direction};
}

Plane plane_of(const MovingPolygon& polygon) {
  Plane plane{normal_of(polygon), {}, {}, {}};
  plane.square = dot(plane.normal, plane.normal);
  for (std::size_t i = 0; i < polygon.side_count(); ++i)
    plane.within[i] = dot(plane.normal, cross(corner(polygon, i), corner(polygon, i + 1)));
  return plane;
}

}  // namespace

/// Its plane where the foot of the perpendicular lies inside, else the nearest of the sides that part the two; a side
/// that holds the origin in any case. No other side is nearer: from the nearest point of a convex polygon the foot lies
/// along the outward normal of a side, or between those of two that meet, so beyond one of them.
NearestPoint nearest_point(const MovingPolygon& polygon) {
  NearestPoint nearest{{}, 0, {}, false, plane_of(polygon)};
  Plane& plane = nearest.plane;
  bool is_first = true, is_inside = plane.square.sign() > 0;
  for (std::size_t i = 0; i < polygon.side_count(); ++i) {
    if (plane.within[i].sign() > 0) continue;
    is_inside = is_inside && plane.within[i].sign() == 0;
    auto [square, along] = nearest_on_side(corner(polygon, i), corner(polygon, i + 1));
    if (!is_first && !is_smaller(square, nearest.square)) continue;
    is_first = false;
    nearest.square = std::move(square);
    nearest.along = std::move(along);
    nearest.side = i;
    if (nearest.square.above.sign() == 0) return nearest;
  }
  nearest.is_inside = is_inside;
  if (!is_inside) return nearest;
  plane.height = dot(plane.normal, corner(polygon, 0));
  nearest.square = {plane.height * plane.height, plane.square};
  return nearest;
}

ExactDistance exact_distance(PairKind kind, const PairPoints& points, double time) {
  TAMIS_ASSERT(is_finite(points) && 0 <= time && time <= 1);
  const MovingPolygon moving = difference_polygon(kind, points);
  std::optional<MovingPolygon> later;
  const MovingPolygon& polygon = time > 0 ? later.emplace(at_rest_at(moving, shortest_cell_at(time))) : moving;
  const NearestPoint nearest = nearest_point(polygon);
  ExactDistance result = nearest.is_inside ? inside(moving, nearest.plane) : on_side(kind, polygon, moving, nearest);
  if (nearest.square.above.sign() > 0)
    result.distance = wide(nearest.square).root().times_two_to(polygon.exponent).value();
  return result;
}

Vec3<double> exact_normal(PairKind kind, const PairPoints& points, double time) {
  TAMIS_ASSERT(is_finite(points) && 0 <= time && time <= 1);
  const Vec3<double> normal =
      unit_vector_of(normal_of(at_rest_at(difference_polygon(kind, points), shortest_cell_at(time))));
  return kind == PairKind::edge_edge ? -normal : normal;  // the polygon's sides are -e and f
}

}  // namespace tamis

#include "pair/exact/start_distance.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "numbers/assert.hpp"
#include "pair/exact/nearest_point.hpp"
#include "pair/motion/polynomials.hpp"

namespace tamis {
namespace {

using IntegerVec = Vec3<Integer>;

/// The largest squared speed of a corner. Every point of the polygon moves at a convex combination of corners'
/// velocities. So none is faster than a corner.
Integer squared_speed(const MovingPolygon& polygon) {
  Integer largest;
  for (std::size_t i = 0; i < polygon.corner_count; ++i) {
    const IntegerVec velocity = polygon.corner(i).at1 - polygon.corner(i).at0;
    Integer square = dot(velocity, velocity);
    if ((square - largest).sign() > 0) largest = std::move(square);
  }
  return largest;
}

/// Squared distance minus squared separation, in the unit of the polygon squared: above / below.
template <class Number>
Fraction<Number> squared_excess(const Polygon<Number>& polygon, const Fraction<Number>& square, double separation) {
  const Number s = scaled_to_integer<Number>(separation, polygon.exponent);
  return {square.above - s * s * square.below, square.below};
}

/// Is the origin within the separation of the polygon? Nothing where a sign is not certain.
std::optional<bool> is_surely_within(const Polygon<Estimate>& polygon, double separation) {
  const auto nearest = NearestPointSearch<Estimate>::in(polygon);
  const Estimate above = squared_excess(polygon, nearest.square, separation).above;
  if (!nearest.is_sure || !above.has_sign()) return {};
  return above.sign() <= 0;
}

}  // namespace

bool is_within(const Polygon<Integer>& polygon, double separation) {
  TAMIS_ASSERT(separation >= 0 && std::isfinite(separation));
  return squared_excess(polygon, NearestPointSearch<Integer>::in(polygon).square, separation).above.sign() <= 0;
}

bool starts_within(PairKind kind, const PairPoints& points, double separation) {
  TAMIS_ASSERT(separation >= 0);
  if (separation == 0 && !may_start_coplanar(make_motion(kind, points))) return false;
  const auto estimated = is_surely_within(start_polygon<Estimate>(kind, points, separation), separation);
  return estimated ? *estimated : is_within(start_polygon(kind, points, separation), separation);
}

double apart_from_start(PairKind kind, const PairPoints& points, double separation) {
  TAMIS_ASSERT(separation >= 0);
  const MovingPolygon polygon = difference_polygon(kind, points, separation);
  const auto start = polygon_at(polygon, {});
  const Fraction<Integer> square = NearestPointSearch<Integer>::in(start).square,
                          excess = squared_excess(start, square, separation);
  if (excess.above.sign() <= 0) return 0;
  const Integer speed = squared_speed(polygon);
  if (speed.sign() == 0) return std::numeric_limits<double>::infinity();
  // distance - separation = (distance^2 - separation^2) / (distance + separation)
  const WideDouble distance = wide(square).root().times_two_to(polygon.exponent);
  const WideDouble reach = separation > 0 ? distance + WideDouble::of(separation) : distance;
  const WideDouble fastest = WideDouble::of(speed).root().times_two_to(polygon.exponent);
  const WideDouble time =
      WideDouble::of(excess.above).times_two_to(2 * polygon.exponent) / WideDouble::of(square.below) / reach / fastest;
  return time.rounded_down();
}

}  // namespace tamis

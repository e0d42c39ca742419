#include "solve/start_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solve/exact_distance.hpp"

namespace tamis {
namespace {

using Vec = Vec3<Integer>;

/// Convex combinations of the corners' velocities are those of all points of the polygon.
Integer squared_speed(const MovingPolygon& polygon) {
  Integer largest;
  for (std::size_t i = 0; i < polygon.corner_count; ++i) {
    const Vec velocity = polygon.corner(i).at1 - polygon.corner(i).at0;
    Integer square = dot(velocity, velocity);
    if ((square - largest).sign() > 0) largest = std::move(square);
  }
  return largest;
}

}  // namespace

double apart_from_start(PairKind kind, const PairPoints& points, double separation) {
  const MovingPolygon polygon = difference_polygon(kind, points);
  const Fraction square = nearest_point(polygon).square;
  // separation = mantissa 2^exponent; squares in the unit 4^unit, in which both are integers over square.below.
  int exponent = 0;
  const Integer mantissa(static_cast<std::int64_t>(std::ldexp(std::frexp(separation, &exponent), 53)));
  exponent -= 53;
  const long unit = std::min(polygon.exponent, exponent);
  const Integer excess = (square.above << static_cast<unsigned long>(2 * (polygon.exponent - unit))) -
                         ((mantissa * mantissa * square.below) << static_cast<unsigned long>(2 * (exponent - unit)));
  if (excess.sign() <= 0) return 0;
  const Integer speed = squared_speed(polygon);
  if (speed.sign() == 0) return std::numeric_limits<double>::infinity();
  // distance - separation = (distance^2 - separation^2) / (distance + separation)
  const Magnitude distance = Magnitude::of(square).root().times_two_to(polygon.exponent);
  const Magnitude reach = separation > 0 ? distance + Magnitude::of(separation) : distance;
  const Magnitude fastest = Magnitude::of(speed).root().times_two_to(polygon.exponent);
  const Magnitude time = Magnitude::of(excess).times_two_to(2 * unit) / Magnitude::of(square.below) / reach / fastest;
  constexpr double kRounding = 0x1p-46;  // about ten operations
  return time.value() * (1 - kRounding);
}

}  // namespace tamis

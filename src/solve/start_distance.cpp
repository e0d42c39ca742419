#include "solve/start_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solve/moving_polygon.hpp"

namespace tamis {
namespace {

using Vec = Vec3<Integer>;

struct Fraction {
  Integer above, below{1};
};

bool is_smaller(const Fraction& a, const Fraction& b) { return (a.above * b.below - b.above * a.below).sign() < 0; }

/// Squared distance of the origin to the segment xy.
Fraction squared_distance_to_side(const Vec& x, const Vec& y) {
  const Vec side = y - x;
  if (dot(x, side).sign() >= 0) return {dot(x, x)};
  if (dot(y, side).sign() <= 0) return {dot(y, y)};
  const Vec n = cross(x, y);
  return {dot(n, n), dot(side, side)};
}

/// Of the origin to the polygon at t=0: to its plane where the foot of the perpendicular lies inside, else to a side.
Fraction squared_distance(const MovingPolygon& polygon) {
  const auto corner = [&](std::size_t i) -> const Vec& { return polygon.corner(i).at0; };
  const Vec n = cross(corner(1) - corner(0), corner(polygon.corner_count - 1) - corner(0));
  bool is_inside = dot(n, n).sign() > 0;
  Fraction nearest = squared_distance_to_side(corner(0), corner(1));
  for (std::size_t i = 0; i < polygon.corner_count; ++i) {
    is_inside = is_inside && dot(n, cross(corner(i), corner(i + 1))).sign() >= 0;
    Fraction distance = squared_distance_to_side(corner(i), corner(i + 1));
    if (is_smaller(distance, nearest)) nearest = std::move(distance);
  }
  const Integer height = dot(n, corner(0));
  return is_inside ? Fraction{height * height, dot(n, n)} : nearest;
}

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

/// A positive number with room for any exponent; each operation is off by 2^-51 of the result at most.
struct Magnitude {
  double mantissa;
  long exponent;

  static Magnitude of(const Integer& a) {
    long exponent = 0;
    const double mantissa = mpz_get_d_2exp(&exponent, a.get());
    return {mantissa, exponent};
  }
  static Magnitude of(double a) {
    int exponent = 0;
    const double mantissa = std::frexp(a, &exponent);
    return {mantissa, exponent};
  }
  Magnitude times_two_to(long power) const { return {mantissa, exponent + power}; }
  /// REQUIRES: 0 <= `mantissa` < 4 or so, as all the others leave it.
  Magnitude root() const {
    const bool is_odd = exponent % 2 != 0;
    return {std::sqrt(is_odd ? 2 * mantissa : mantissa), (exponent - (is_odd ? 1 : 0)) / 2};
  }
  friend Magnitude operator/(const Magnitude& a, const Magnitude& b) {
    return {a.mantissa / b.mantissa, a.exponent - b.exponent};
  }
  friend Magnitude operator+(const Magnitude& a, const Magnitude& b) {
    if (a.exponent < b.exponent) return b + a;
    const long shift = std::max(b.exponent - a.exponent, -2000L);
    return {a.mantissa + std::ldexp(b.mantissa, static_cast<int>(shift)), a.exponent};
  }
  /// A double below it by about ten roundings, or by one spacing of the smallest doubles.
  double rounded_down() const {
    constexpr double kRounding = 0x1p-46, kNormal = std::numeric_limits<double>::min();
    const double value = std::ldexp(mantissa * (1 - kRounding), static_cast<int>(std::clamp(exponent, -5000L, 5000L)));
    return value < kNormal ? std::nextafter(value, 0) : value;
  }
};

/// Squared distance minus squared separation, in the unit of the polygon squared: above / below.
Fraction excess_at_start(const MovingPolygon& polygon, const Fraction& square, double separation) {
  const Integer s = scaled_to_integer(separation, polygon.exponent);
  return {square.above - s * s * square.below, square.below};
}

}  // namespace

bool starts_within(const MovingPolygon& polygon, double separation) {
  return excess_at_start(polygon, squared_distance(polygon), separation).above.sign() <= 0;
}

double apart_from_start(PairKind kind, const PairPoints& points, double separation) {
  const MovingPolygon polygon = difference_polygon(kind, points, separation);
  const Fraction square = squared_distance(polygon), excess = excess_at_start(polygon, square, separation);
  if (excess.above.sign() <= 0) return 0;
  const Integer speed = squared_speed(polygon);
  if (speed.sign() == 0) return std::numeric_limits<double>::infinity();
  // distance - separation = (distance^2 - separation^2) / (distance + separation)
  const Magnitude below = Magnitude::of(square.below);
  const Magnitude distance = (Magnitude::of(square.above) / below).root().times_two_to(polygon.exponent);
  const Magnitude reach = separation > 0 ? distance + Magnitude::of(separation) : distance;
  const Magnitude fastest = Magnitude::of(speed).root().times_two_to(polygon.exponent);
  const Magnitude time = Magnitude::of(excess.above).times_two_to(2L * polygon.exponent) / below / reach / fastest;
  return time.rounded_down();
}

}  // namespace tamis

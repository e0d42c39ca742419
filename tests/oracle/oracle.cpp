#include "oracle/oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "oracle/somewhere.hpp"

namespace tamis::oracle {
namespace {

using Vector = std::array<Polynomial, 3>;  ///< a moving vector: each component is a polynomial in time
using Triangle = std::array<Vector, 3>;

Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Polynomial dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

constexpr int kNoBits = 2000;

/// The exponent of the last set bit of a double; for zero kNoBits, which is above all exponents.
int lowest_exponent(double x) {
  if (x == 0) return kNoBits;
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  auto digits = static_cast<long long>(std::ldexp(fraction, 53));
  for (exponent -= 53; digits % 2 == 0; digits /= 2) ++exponent;
  return exponent;
}

/// x 2^shift, an integer.
Integer scaled_to_integer(double x, int shift) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  Integer result(static_cast<std::int64_t>(std::ldexp(fraction, 53)));
  exponent += shift - 53;
  if (exponent >= 0) return result << static_cast<unsigned>(exponent);
  return result >> static_cast<unsigned>(-exponent);  // the bits shifted out are zero
}

/// The four points as polynomials that go through `times` while t goes from 0 to 1. All lengths are scaled so that
/// coefficients are integers.
struct IntegerMotion {
  std::array<Vector, 4> points;
  Integer unit = 1;  ///< the length 2^`exponent`
  int exponent = 0;
};

IntegerMotion integer_motion(const Motion& motion, const Times& times, double separation) {
  int lowest = lowest_exponent(separation),
      lowest_time = std::min(lowest_exponent(times.from), lowest_exponent(times.to));
  for (const auto* points : {&motion.start, &motion.end})
    for (const Point& p : *points)
      for (double x : p) lowest = std::min(lowest, lowest_exponent(x));
  lowest_time = std::min(lowest_time, 0);
  if (lowest == kNoBits) lowest = 0;

  IntegerMotion result;
  result.exponent = -lowest;
  const Integer one = scaled_to_integer(1, -lowest_time);
  const Integer from = scaled_to_integer(times.from, -lowest_time), to = scaled_to_integer(times.to, -lowest_time);
  result.unit = one;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const Integer x0 = scaled_to_integer(motion.start[i][k], -lowest),
                    x1 = scaled_to_integer(motion.end[i][k], -lowest);
      const Integer at_from = (one - from) * x0 + from * x1, at_to = (one - to) * x0 + to * x1;
      result.points[i][k] = Polynomial({at_from, at_to - at_from});
    }
  return result;
}

/// The moving triangles: the features touch when one of them contains the origin.
std::vector<Triangle> triangles_of(PairKind kind, const std::array<Vector, 4>& p) {
  if (kind == PairKind::vertex_face) return {{p[1] - p[0], p[2] - p[0], p[3] - p[0]}};
  if (kind == PairKind::vertex_edge) return {{p[1] - p[0], p[2] - p[0], p[2] - p[0]}};
  if (kind == PairKind::vertex_vertex) return {{p[1] - p[0], p[1] - p[0], p[1] - p[0]}};
  return {{p[0] - p[2], p[1] - p[2], p[1] - p[3]}, {p[0] - p[2], p[0] - p[3], p[1] - p[3]}};
}

std::size_t vertex_count(PairKind kind) {
  return kind == PairKind::vertex_vertex ? 2 : kind == PairKind::vertex_edge ? 3 : 4;
}

/// Does one feature lie beyond the other along an axis at both ends of the step, and thus all the time?
bool boxes_are_apart(PairKind kind, const Motion& m) {
  const std::size_t second = kind == PairKind::edge_edge ? 2 : 1, count = vertex_count(kind);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::array<double, 2> low, high;
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-low[0]);
    for (const auto* points : {&m.start, &m.end})
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t feature = i < second ? 0 : 1;
        low[feature] = std::min(low[feature], (*points)[i][axis]);
        high[feature] = std::max(high[feature], (*points)[i][axis]);
      }
    if (low[0] > high[1] || low[1] > high[0]) return true;
  }
  return false;
}

Condition positive(Polynomial p) { return {std::move(p), Relation::positive}; }
Condition not_negative(Polynomial p) { return {std::move(p), Relation::not_negative}; }

/// q x r = 0 and q.r <= 0. Looks at the roots of one component that is not always zero: there the others must vanish.
bool side_meets_origin(const Vector& q, const Vector& r, Range range) {
  const Vector n = cross(q, r);
  for (const Polynomial& component : n)
    if (component.never_vanishes_on_unit_interval()) return false;
  const Condition opposite = not_negative(-dot(q, r));
  for (std::size_t k = 0; k < 3; ++k) {
    if (n[k].is_zero()) continue;
    const Polynomial &a = n[(k + 1) % 3], &b = n[(k + 2) % 3];
    return holds_somewhere(n[k], {not_negative(-(a * a + b * b)), opposite}, range);
  }
  return holds_somewhere({}, {opposite}, range);
}

bool interior_meets_origin(const Triangle& q, Range range) {
  const Vector n01 = cross(q[0], q[1]), n12 = cross(q[1], q[2]), n20 = cross(q[2], q[0]);
  // If det = 0, the three cross products are parallel: so the third dot product is positive if the other two are.
  return holds_somewhere(dot(n01, q[2]), {positive(dot(n01, n12)), positive(dot(n12, n20))}, range);
}

/// Does the origin come within the distance of corner q, or of the side's inside at the foot of the perpendicular?
bool side_within(const Vector& q, const Vector& r, const Polynomial& squared, Range range) {
  const Vector side = r - q, n = cross(q, r);
  return holds_somewhere({}, {not_negative(squared - dot(q, q))}, range) ||
         holds_somewhere(
             {}, {not_negative(squared * dot(side, side) - dot(n, n)), positive(-dot(q, side)), positive(dot(r, side))},
             range);
}

/// Does the origin come within the distance of the triangle where the foot of its perpendicular lies inside?
bool interior_within(const Triangle& q, const Polynomial& squared, Range range) {
  const Vector n = cross(q[1] - q[0], q[2] - q[0]);
  const Polynomial height = dot(n, q[0]);
  std::vector<Condition> conditions{not_negative(squared * dot(n, n) - height * height)};
  for (std::size_t i = 0; i < 3; ++i) conditions.push_back(positive(dot(n, cross(q[i], q[(i + 1) % 3]))));
  return holds_somewhere({}, conditions, range);
}

using Values = std::array<Rational, 3>;  ///< a vector at one time

Values operator-(const Values& a, const Values& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Rational dot(const Values& a, const Values& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Values cross(const Values& a, const Values& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// REQUIRES: `v` moves linearly.
Values at(const Vector& v, const Rational& t) {
  Values result;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; !v[k].is_zero() && i <= v[k].degree(); ++i)
      result[k] += i == 0 ? Rational(v[k][0]) : v[k][1] * t;
  return result;
}

Rational squared_distance_to_side(const Values& q, const Values& r) {
  const Values side = r - q, n = cross(q, r);
  if (dot(q, side) >= 0) return dot(q, q);
  if (dot(r, side) <= 0) return dot(r, r);
  return dot(n, n) / dot(side, side);
}

/// Squared distance of the origin from the triangle at time t.
Rational squared_distance(const Triangle& triangle, const Rational& t) {
  const std::array<Values, 3> q{at(triangle[0], t), at(triangle[1], t), at(triangle[2], t)};
  const Values n = cross(q[1] - q[0], q[2] - q[0]);
  bool is_inside = dot(n, n) > 0;
  Rational nearest = dot(q[0], q[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    const Values &a = q[i], &b = q[(i + 1) % 3];
    nearest = std::min(nearest, squared_distance_to_side(a, b));
    is_inside = is_inside && dot(n, cross(a, b)) >= 0;
  }
  const Rational height = dot(n, q[0]);
  return is_inside ? Rational(height * height / dot(n, n)) : nearest;
}

/// A bound of the corners' speed: the largest sum of the |components| of a velocity.
Rational speed_of(const Triangle& triangle) {
  Rational speed = 0;
  for (const Vector& corner : triangle) {
    const Values velocity = at(corner, 1) - at(corner, 0);
    speed = std::max(speed, Rational(abs(velocity[0]) + abs(velocity[1]) + abs(velocity[2])));
  }
  return speed;
}

enum class Near { no, yes, unknown };

/// Answers for most pairs without algebra: a distance falls no faster than the corners move, so the distance in the
/// middle of a part of the step bounds it in the whole part.
Near near_by_sampling(const Triangle& triangle, const Integer& separation, const Rational& from, const Rational& to,
                      int halvings) {
  const Rational middle = (from + to) / 2, reach = separation + speed_of(triangle) * (to - from) / 2;
  const Rational squared = squared_distance(triangle, middle);
  if (squared <= separation * separation) return Near::yes;
  if (squared > reach * reach) return Near::no;
  if (halvings == 0) return Near::unknown;
  const Near left = near_by_sampling(triangle, separation, from, middle, halvings - 1);
  if (left == Near::yes) return left;
  const Near right = near_by_sampling(triangle, separation, middle, to, halvings - 1);
  return right == Near::no ? left : right;
}

/// Does one of these triangles come within a distance of the origin?
struct WithinQuestion {
  WithinQuestion(PairKind kind, const Motion& motion, double distance, const Times& times)
      : range(times.half_open ? Range::half_open : Range::closed) {
    const IntegerMotion m = integer_motion(motion, times, distance);
    triangles = triangles_of(kind, m.points);
    separation = m.unit * scaled_to_integer(distance, m.exponent);
    squared = Polynomial({separation * separation});
  }

  /// Decides one triangle by algebra.
  bool holds_for(const Triangle& q) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (side_within(q[i], q[(i + 1) % 3], squared, range)) return true;
    return interior_within(q, squared, range);
  }

  Range range;
  std::vector<Triangle> triangles;
  Integer separation;
  Polynomial squared;
};

/// For the part [from, to] of the question's times. The nearest triangle gives the distance, the fastest one bounds the
/// speed of all.
Always stays_within(const WithinQuestion& ask, const Rational& from, const Rational& to, int halvings) {
  const Rational middle = (from + to) / 2;
  Rational squared = squared_distance(ask.triangles[0], middle), speed = 0;
  for (const Triangle& q : ask.triangles) {
    squared = std::min(squared, squared_distance(q, middle));
    speed = std::max(speed, speed_of(q));
  }
  const Rational left = ask.separation - speed * (to - from) / 2;
  if (squared > ask.separation * ask.separation) return Always::no;
  if (left >= 0 && squared <= left * left) return Always::yes;
  if (halvings == 0) return Always::unknown;
  const Always before = stays_within(ask, from, middle, halvings - 1);
  if (before == Always::no) return before;
  const Always after = stays_within(ask, middle, to, halvings - 1);
  return after == Always::yes ? before : after;
}

}  // namespace

Always stays_within(PairKind kind, const Motion& motion, double separation, const Times& times) {
  constexpr int kHalvings = 6;
  return stays_within(WithinQuestion(kind, motion, separation, times), 0, 1, kHalvings);
}

bool touches(PairKind kind, const Motion& motion, const Times& times) {
  if (boxes_are_apart(kind, motion)) return false;
  const Range range = times.half_open ? Range::half_open : Range::closed;
  for (const Triangle& q : triangles_of(kind, integer_motion(motion, times, 0).points)) {
    if (dot(cross(q[0], q[1]), q[2]).never_vanishes_on_unit_interval()) continue;  // never in the triangle's plane
    for (std::size_t i = 0; i < 3; ++i)
      if (side_meets_origin(q[i], q[(i + 1) % 3], range)) return true;
    if (interior_meets_origin(q, range)) return true;
  }
  return false;
}

bool comes_within(PairKind kind, const Motion& motion, double separation, const Times& times) {
  constexpr int kHalvings = 5;
  const WithinQuestion ask(kind, motion, separation, times);
  return std::any_of(ask.triangles.begin(), ask.triangles.end(), [&](const Triangle& q) {
    const Near near = near_by_sampling(q, ask.separation, 0, 1, kHalvings);
    return near == Near::yes || (near == Near::unknown && ask.holds_for(q));
  });
}

bool comes_within_by_algebra(PairKind kind, const Motion& motion, double separation, const Times& times) {
  const WithinQuestion ask(kind, motion, separation, times);
  return std::any_of(ask.triangles.begin(), ask.triangles.end(), [&](const Triangle& q) { return ask.holds_for(q); });
}

}  // namespace tamis::oracle

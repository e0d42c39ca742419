#include "pair/exact/exact.hpp"

#include <algorithm>
#include <array>

#include "numbers/assert.hpp"
#include "pair/exact/exact_separation.hpp"
#include "pair/exact/moving_polygon.hpp"
#include "pair/exact/start_distance.hpp"
#include "pair/motion/pair_kinds.hpp"
#include "pair/motion/polynomials.hpp"

namespace tamis {
namespace {

using Axis = Integer Vec3<Integer>::*;
constexpr std::array<Axis, 3> kAxes{&Vec3<Integer>::x, &Vec3<Integer>::y, &Vec3<Integer>::z};

template <class Product>
IntegerPolynomial quadratic(const Moving<Integer>& x, const Moving<Integer>& y, const Product& product) {
  return IntegerPolynomial::from_bernstein(product_polynomial(x, y, product));
}

/// (x cross y) along one axis.
IntegerPolynomial cross_along(std::size_t axis, const Moving<Integer>& x, const Moving<Integer>& y) {
  const Axis next = kAxes[(axis + 1) % 3], last = kAxes[(axis + 2) % 3];
  return quadratic(x, y, [&](const Vec3<Integer>& a, const Vec3<Integer>& b) -> Integer {
    return a.*next * b.*last - a.*last * b.*next;
  });
}

/// One side of the polygon, from corner x to corner y. It holds the origin where x cross y = 0 and x.y <= 0.
struct Side {
  std::array<IntegerPolynomial, 3> cross;
  IntegerPolynomial dot;

  Side(const Moving<Integer>& x, const Moving<Integer>& y)
      : dot(quadratic(x, y, [](const Vec3<Integer>& a, const Vec3<Integer>& b) { return tamis::dot(a, b); })) {
    for (std::size_t k = 0; k < 3; ++k) cross[k] = cross_along(k, x, y);
  }

  bool holds_origin(AlgebraicTime& time) const {
    return std::all_of(cross.begin(), cross.end(), [&](const auto& c) { return time.sign_of(c) == 0; }) &&
           time.sign_of(dot) <= 0;
  }

  /// A polynomial that vanishes when the side begins or ceases to hold the origin. Zero only if the side always does.
  const IntegerPolynomial& event() const {
    for (const auto& c : cross)
      if (!c.is_zero()) return c;
    return dot;
  }
};

class MovingPolygonTest {
 public:
  /// Keeps a reference.
  explicit MovingPolygonTest(const MovingPolygon& polygon)
      : polygon_(polygon),
        normal_(normal_polynomial(polygon)),
        coplanarity_(IntegerPolynomial::from_bernstein(coplanarity_polynomial(polygon.corner(0), normal_))) {}

  /// Adds the times of touching at which a span of touching may begin or end. At these times the origin comes into the
  /// polygon's plane or out of it. If it is always in that plane, it passes through a side at these times.
  void add_times(TouchingTimes& times) const {
    if (!coplanarity_.is_zero())
      return times.add_roots(coplanarity_, [&](AlgebraicTime& time) { return contains_origin(time); });
    for (std::size_t i = 0; i < polygon_.side_count(); ++i) {
      const Side passed = side(i);
      times.add_roots(passed.event(), [&](AlgebraicTime& time) { return passed.holds_origin(time); });
    }
  }

 private:
  Side side(std::size_t i) const { return {polygon_.corner(i), polygon_.corner(i + 1)}; }

  /// REQUIRES (not checked: exact): the origin lies in the polygon's plane at this time.
  bool contains_origin(AlgebraicTime& time) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const Axis axis = kAxes[k];
      const auto along = IntegerPolynomial::from_bernstein<3>({normal_[0].*axis, normal_[1].*axis, normal_[2].*axis});
      if (const int orientation = time.sign_of(along)) return contains_projected_origin(time, k, orientation);
    }
    return is_on_boundary(time);
  }

  /// True if the polygon's projection along `axis` holds the origin. The projection is convex, with this orientation.
  /// It does if the origin is on the inner side of all sides.
  bool contains_projected_origin(AlgebraicTime& time, std::size_t axis, int orientation) const {
    for (std::size_t i = 0; i < polygon_.corner_count; ++i)
      if (time.sign_of(cross_along(axis, polygon_.corner(i), polygon_.corner(i + 1))) == -orientation) return false;
    return true;
  }

  bool is_on_boundary(AlgebraicTime& time) const {
    for (std::size_t i = 0; i < polygon_.side_count(); ++i)
      if (side(i).holds_origin(time)) return true;
    return false;
  }

  const MovingPolygon& polygon_;
  std::array<Vec3<Integer>, 3> normal_;
  IntegerPolynomial coplanarity_;
};

MovingPolygon polygon_for(PairKind kind, const PairPoints& points, double separation) {
  return separation > 0 ? difference_polygon(kind, points, separation) : stretched_polygon(kind, points);
}

void add_times(const MovingPolygon& polygon, double separation, TouchingTimes& times) {
  if (separation > 0)
    add_times_within(polygon, separation, times);
  else
    MovingPolygonTest(polygon).add_times(times);
}

}  // namespace

Decision decide_exactly(PairKind kind, const PairPoints& points, double separation, double latest) {
  TAMIS_ASSERT(separation >= 0 && std::isfinite(separation) && is_finite(points) && 0 <= latest && latest <= 1);
  if (starts_within(kind, points, separation)) return {Verdict::touches, 0, 0};
  TouchingTimes times(TouchingTimes::Wanted::first, latest);
  add_times(polygon_for(kind, points, separation), separation, times);
  return times.first();
}

Decision decide_recontact_exactly(PairKind kind, const PairPoints& points, double separation) {
  TAMIS_ASSERT(separation >= 0 && std::isfinite(separation) && is_finite(points));
  const MovingPolygon polygon = polygon_for(kind, points, separation);
  TouchingTimes times(TouchingTimes::Wanted::recontact);
  add_times(polygon, separation, times);
  return times.first_recontact(
      [&](const DyadicCell& time) { return is_within(polygon_at(polygon, time), separation); });
}

int side_just_before(PairKind kind, const PairPoints& points, double time) {
  TAMIS_ASSERT(can_cross(kind) && is_finite(points) && 0 <= time && time <= 1);
  // For both kinds the first feature's place along e x f is the place of corner 0 along the polygon's normal. For edges
  // the normal is -(e x f), and the corners lead from the first edge to the second.
  const MovingPolygon polygon = stretched_polygon(kind, points);
  auto k = IntegerPolynomial::from_bernstein(coplanarity_polynomial(polygon.corner(0), normal_polynomial(polygon)));
  AlgebraicTime now = AlgebraicTime::exactly(shortest_cell_at(time));
  for (int before = 1; !k.is_zero(); before = -before, k = k.derivative())
    if (const int sign = now.sign_of(k)) return before * sign;
  return 0;
}

}  // namespace tamis

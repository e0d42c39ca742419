#include "solve/exact.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "motion/polynomials.hpp"
#include "solve/moving_polygon.hpp"
#include "solve/root_isolation.hpp"

namespace tamis {
namespace {

constexpr std::array kAxes{&Vec3<Integer>::x, &Vec3<Integer>::y, &Vec3<Integer>::z};

using Bracket = AlgebraicTime::Bracket;

IntegerPolynomial component(const std::array<Vec3<Integer>, 3>& quadratic, Integer Vec3<Integer>::*axis) {
  return IntegerPolynomial::from_bernstein<3>({quadratic[0].*axis, quadratic[1].*axis, quadratic[2].*axis});
}

/// One side of the polygon, from corner x to corner y: it holds the origin where x cross y = 0 and x.y <= 0.
struct Side {
  std::array<IntegerPolynomial, 3> cross;
  IntegerPolynomial dot;

  Side(const Moving<Integer>& x, const Moving<Integer>& y)
      : dot(IntegerPolynomial::from_bernstein(product_polynomial(
            x, y, [](const Vec3<Integer>& a, const Vec3<Integer>& b) { return tamis::dot(a, b); }))) {
    const auto n = normal_polynomial(x, y);
    for (std::size_t k = 0; k < 3; ++k) cross[k] = component(n, kAxes[k]);
  }

  bool holds_origin(AlgebraicTime& time) const {
    return std::all_of(cross.begin(), cross.end(), [&](const auto& c) { return time.sign_of(c) == 0; }) &&
           time.sign_of(dot) <= 0;
  }

  /// A polynomial that vanishes whenever the side begins to hold the origin; zero only if it always does.
  const IntegerPolynomial& event() const {
    for (const auto& c : cross)
      if (!c.is_zero()) return c;
    return dot;
  }
};

class MovingPolygonTest {
 public:
  MovingPolygonTest(PairKind kind, const PairPoints& points)
      : polygon_(difference_polygon(kind, points)),
        normal_(normal_polynomial(polygon_.corner(1) - polygon_.corner(0),
                                  polygon_.corner(polygon_.corner_count - 1) - polygon_.corner(0))) {}

  std::optional<Bracket> first_contact() const {
    const auto coplanarity = IntegerPolynomial::from_bernstein(coplanarity_polynomial(polygon_.corner(0), normal_));
    if (coplanarity.is_zero()) return first_contact_in_plane();
    for (AlgebraicTime& time : roots_in_unit_interval(coplanarity))
      if (contains_origin(time)) return time.bracket();
    return std::nullopt;
  }

 private:
  Side side(std::size_t i) const { return {polygon_.corner(i), polygon_.corner(i + 1)}; }

  /// REQUIRES: the origin lies in the polygon's plane at this time.
  bool contains_origin(AlgebraicTime& time) const {
    for (const auto axis : kAxes)
      if (const int orientation = time.sign_of(component(normal_, axis)))
        return contains_projected_origin(time, axis, orientation);
    return is_on_boundary(time);
  }

  /// The polygon's projection along `axis` is convex, with that orientation: the origin is on the inner side of all
  /// sides.
  bool contains_projected_origin(AlgebraicTime& time, Integer Vec3<Integer>::*axis, int orientation) const {
    for (std::size_t i = 0; i < polygon_.corner_count; ++i)
      if (time.sign_of(component(normal_polynomial(polygon_.corner(i), polygon_.corner(i + 1)), axis)) == -orientation)
        return false;
    return true;
  }

  bool is_on_boundary(AlgebraicTime& time) const {
    for (std::size_t i = 0; i < polygon_.corner_count; ++i)
      if (side(i).holds_origin(time)) return true;
    return false;
  }

  /// The origin is always in the polygon's plane: it is inside at t=0, or enters through a side.
  std::optional<Bracket> first_contact_in_plane() const {
    AlgebraicTime start = AlgebraicTime::exactly({0, 0});
    if (contains_origin(start)) return Bracket{0, 0};
    std::optional<Bracket> first;
    for (std::size_t i = 0; i < polygon_.corner_count; ++i) {
      const auto entry = first_contact_of(side(i));
      if (entry && (!first || entry->lower < first->lower || entry->upper < first->upper)) first = entry;
    }
    return first;
  }

  static std::optional<Bracket> first_contact_of(const Side& side) {
    for (AlgebraicTime& time : roots_in_unit_interval(side.event()))
      if (side.holds_origin(time)) return time.bracket();
    return std::nullopt;
  }

  MovingPolygon polygon_;
  std::array<Vec3<Integer>, 3> normal_;
};

}  // namespace

ExactDecision decide_exactly(PairKind kind, const PairPoints& points) {
  const auto first = MovingPolygonTest(kind, points).first_contact();
  if (!first) return {};
  return {true, first->lower, first->upper};
}

}  // namespace tamis

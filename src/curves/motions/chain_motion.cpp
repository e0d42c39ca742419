#include "curves/motions/chain_motion.hpp"

#include <algorithm>
#include <cmath>

#include "curves/motions/fine_point.hpp"
#include "curves/motions/rigid_transform.hpp"
#include "curves/motions/rounded_rotation.hpp"
#include "numbers/axes.hpp"
#include "numbers/error_bounds.hpp"
#include "numbers/finite.hpp"
#include "numbers/length.hpp"

namespace tamis {
namespace {

/// True if a rotation vector of the link is longer than kLargestRoundedAngle, or not finite.
bool turns_far(const RigidLink& link) {
  const auto is_far = [](const Pose& pose) {
    const auto [x, y, z] = pose.rotation;
    return !is_finite(pose.rotation) || length_of(x, y, z) > kLargestRoundedAngle;
  };
  return is_far(link.start) || is_far(link.end);
}

double largest_coordinate(const Point& x) { return std::max({std::fabs(x[0]), std::fabs(x[1]), std::fabs(x[2])}); }

RoundedTransform rounded(const RigidTransform& exact) {
  RoundedTransform rounded{};
  const auto take = [](const Vec3<FineInterval>& entries, double& error) {
    const auto one = [&](const FineInterval& entry) {
      const RoundedNumber number = rounded_number(entry);
      error = std::max(error, number.error);
      return number.value;
    };
    return Point{one(entries.x), one(entries.y), one(entries.z)};
  };
  for (std::size_t i = 0; i < 3; ++i) rounded.rows[i] = take(exact.rows[i], rounded.turn_error);
  rounded.shift = take(exact.shift, rounded.shift_error);
  return rounded;
}

/// Rotations differ by no more, as matrices, than their rotation vectors. So the error of the vector bounds the error
/// of the matrix.
RoundedTransform rounded_near(const RigidLink& link, double time) {
  const RoundedPlace turn = rounded_linear(link.start.rotation, link.end.rotation, time);
  const RoundedPlace shift = rounded_linear(link.start.position, link.end.position, time);
  const RoundedRotation rotation = rounded_rotation(turn.x, kRootOfThree * kRoundedUp * turn.error);
  return {rotation.rows, shift.x, rotation.error, shift.error, 0};
}

}  // namespace

RoundedTransform rounded_link(const RigidLink& link, double time) {
  RoundedTransform result = turns_far(link) ? rounded(transform_of(link, time)) : rounded_near(link, time);
  result.shift_size = largest_coordinate(result.shift);
  return result;
}

/// The transform that applies `inner`, then `outer`. Errors are norms of matrices and of vectors, so they add up. For
/// rotations A', B' and their doubles A, B, off by a and b: |A'B' - AB| <= a + b + a b and |A'p' + q' - Ap - q| <= a
/// |p| + |p' - p| + |q' - q|. Each entry of the product rounds by 3 u |row| |column|. All nine round by a little over 9
/// u; 16 u are given. The entries of the shift round by 4 u (|p|_1 + |q|) each. All round by sqrt(3) of that; 8 u are
/// given.
RoundedTransform after(const RoundedTransform& outer, const RoundedTransform& inner) {
  RoundedTransform both{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      both.rows[i][k] = outer.rows[i][0] * inner.rows[0][k] + outer.rows[i][1] * inner.rows[1][k] +
                        outer.rows[i][2] * inner.rows[2][k];
  both.turn_error = (outer.turn_error + inner.turn_error + outer.turn_error * inner.turn_error + 0x1p-49) * kRoundedUp;
  both.shift = outer.of(inner.shift);
  both.shift_error = ((outer.turn_error + 0x1p-50) * sum_of_sizes(inner.shift) + 0x1p-50 * outer.shift_size +
                      inner.shift_error + outer.shift_error) *
                         kRoundedUp +
                     0x1p-1000;
  both.shift_size = largest_coordinate(both.shift);
  return both;
}

/// Errors of single entries become norms. These are three times as large for nine entries, sqrt(3) times for three.
RoundedTransform with_norms(RoundedTransform transform) {
  transform.turn_error *= 3;
  transform.shift_error *= kRootOfThree * kRoundedUp;
  return transform;
}

RoundedTransform transform_at(const RigidChain& chain, double time) {
  if (chain.empty()) return rounded_link(RigidLink{}, time);
  RoundedTransform result = rounded_link(chain.back(), time);
  if (chain.size() == 1) return result;
  result = with_norms(result);
  for (auto link = chain.rbegin() + 1; link != chain.rend(); ++link)
    result = after(with_norms(rounded_link(*link, time)), result);
  return result;
}

Point turned_by(const RigidChain& chain, double time, const Point& direction) {
  RoundedTransform turn = transform_at(chain, time);
  turn.shift = {0, 0, 0};
  return turn.of(direction);
}

namespace {

/// True if a b is exactly c d. False also where two doubles cannot hold a product.
bool are_equal_products(double a, double b, double c, double d) {
  const auto is_held = [](double x, double y) { return x == 0 || y == 0 || std::fabs(x * y) > 0x1p-900; };
  const DoubleDouble left = DoubleDouble::product_of(a, b), right = DoubleDouble::product_of(c, d);
  return is_held(a, b) && is_held(c, d) && left.high == right.high && left.low == right.low;
}

bool are_parallel(const Point& a, const Point& b) {
  return are_equal_products(a[0], b[1], a[1], b[0]) && are_equal_products(a[1], b[2], a[2], b[1]) &&
         are_equal_products(a[2], b[0], a[0], b[2]);
}

}  // namespace

Point fixed_axis(const RigidChain& chain) {
  const auto turns = [](const RigidLink& link) { return link.start.rotation != link.end.rotation; };
  const auto last = std::find_if(chain.rbegin(), chain.rend(), turns);
  Point axis{0, 0, 0};
  for (auto link = chain.begin(); link != last.base(); ++link)
    for (const Point& rotation : {link->start.rotation, link->end.rotation}) {
      if (axis == Point{0, 0, 0}) axis = rotation;
      if (!are_parallel(axis, rotation)) return {0, 0, 0};
    }
  return axis;
}

ChainBounds::ChainBounds(const RigidChain& chain)
    : turns_(
          std::ranges::any_of(chain, [](const RigidLink& link) { return link.start.rotation != link.end.rotation; })) {
  for (const auto& [start, end] : chain)
    links_.push_back({Interval(change(start.rotation, end.rotation)), Interval(change(start.position, end.position)),
                      Interval(farthest(start.position, end.position))});
}

/// Bounds y and its derivatives, from the innermost link outward. A link takes x, the point that the inner links leave,
/// to y = R x + p. With |R'| <= w and |R''| <= w^2 for a rotation vector that changes by w (docs/numerics/curves.md,
/// "Curved motion"):
///   y' = R' x + R x' + p',   y'' = R'' x + 2 R' x' + R x''.
Curvature ChainBounds::of(double from_origin, double displacement) const {
  Interval place(from_origin), speed(displacement), acceleration(0);
  double orbit_radius = 0;  // the outermost position moves linearly, so it adds no deviation
  for (auto link = links_.rbegin(); link != links_.rend(); ++link) {
    if (link + 1 == links_.rend()) orbit_radius = place.upper;
    const Interval& w = link->turn;
    acceleration = w * w * place + Interval(2) * w * speed + acceleration;
    speed = w * place + speed + link->displacement;
    place = place + link->position;
  }
  return {acceleration.upper, orbit_radius};
}

}  // namespace tamis

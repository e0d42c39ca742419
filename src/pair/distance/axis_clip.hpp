// How long a pair is apart along one axis. The axis is chosen for the pair and may turn with it. Along a fixed axis
// each corner of the Minkowski difference moves linearly. Along an axis that turns at a constant rate it moves
// quadratically. Both are sharper than a bound on the speed of the pair. For double and for SIMD lanes.
#pragma once
#include <limits>

#include "numbers/assert.hpp"
#include "numbers/error_bounds.hpp"
#include "numbers/unit_vector.hpp"
#include "pair/motion/difference_corners.hpp"

namespace tamis {

/// n(t) = direction + (t - now) turn. Of any length, not zero at `now`.
template <class T>
struct TurningAxis {
  Vec3<T> direction;
  Vec3<T> turn{T(0), T(0), T(0)};
};

/// A lower bound, beyond all rounding, of the first x > 0 at which c0 + c1 x + c2 x^2 <= 0; 0 if c0 <= 0, and infinite
/// if there is none. Never NaN.
template <class T>
inline T first_root(const T& c0, const T& c1, const T& c2) {
  // 2 c0 / (sqrt(c1^2 - 4 c0 c2) - c1) with each rounding taken the way that makes it smaller.
  constexpr double u = error_bounds::unit_roundoff<T>;
  const T zero(0), never(std::numeric_limits<double>::infinity());
  const T square = c1 * c1, product = T(4) * c0 * c2;
  const T discriminant = square - product + T(8 * u) * (square + abs(product));
  const T root = sqrt(discriminant);
  const T divisor = root - c1 + T(8 * u) * (root + abs(c1));
  const T first = select(divisor > zero, T(2) * c0 / divisor * T(1 - 4 * u), zero);  // zero where it is NaN
  return select(c0 > zero, select((discriminant < zero) | (divisor <= zero), never, first), zero);
}

/// REQUIRES: `m` is the motion of the whole step, finite.
template <PairKind kind, class T>
class AxisClip {
 public:
  explicit AxisClip(const PairMotion<T>& m)
      : corners_(difference_corners<kind>(m)), separation_(m.separation), size_(m.size_d + m.size_e + m.size_f) {
    TAMIS_ASSERT(is_whole(m));
  }

  /// A time until which, from `now` on, all corners are proven beyond the separation along the axis. No later than
  /// `now` if nothing is proven.
  T apart_until(const T& now, const TurningAxis<T>& axis) const {
    return (now + time_from(now, axis, T(1))) * T(1 - 4 * error_bounds::unit_roundoff<T>);
  }
  /// A time since which, until `now`, all corners are proven beyond it. No earlier than `now` if nothing is proven.
  T apart_since(const T& now, const TurningAxis<T>& axis) const {
    return (now - time_from(now, axis, T(-1))) * T(1 + 4 * error_bounds::unit_roundoff<T>);
  }
  /// For a pair that lies beyond the separation along the axis at `now`. True if it is proven to have done so during
  /// the time `duration` before. This is proven if every corner comes nearer, or is far from the separation. Holds also
  /// where the axis is off by 2 u a component.
  bool was_beyond(const T& now, const TurningAxis<T>& axis, const T& duration) const {
    const UnitAxis unit(axis);
    bool was = duration * unit.turning <= T(1);
    for_each_corner_bound(now, unit, [&](const T& c0, const T& c1, const T& c2, const T& error_rate) {
      const T speed = T(-2) * error_rate - c1, least_speed = speed + min(c2, T(0)) * duration;
      was = was && (least_speed > T(0) || c0 - error_rate + least_speed * duration > T(0));
    });
    return was;
  }
  /// True if all corners are proven beyond the separation along a direction, at `now` and for ever if the motion
  /// continues.
  bool recedes_along(const T& now, const Vec3<T>& direction) const {
    bool parts = true;
    for_each_corner_bound(now, UnitAxis({direction}),
                          [&](const T& c0, const T& c1, const T& /*c2*/, const T& error_rate) {
                            parts = parts && c0 > T(0) && c1 - error_rate > T(0);
                          });
    return parts;
  }
  /// A lower bound, beyond all rounding, of the distance at `now` by a direction of any length; 0 if it proves none.
  T distance_along(const T& now, const Vec3<T>& direction) const {
    std::array<Vec3<T>, std::tuple_size_v<Corners>> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = at_time(corners_[i], now);
    return tamis::distance_along(corners, direction, size_);
  }

 private:
  using Corners = decltype(difference_corners<kind>(PairMotion<T>{}));

  /// The axis scaled to a direction whose largest component is 1. The turn's largest is `turning`.
  struct UnitAxis {
    explicit UnitAxis(const TurningAxis<T>& axis) {
      const T inverse_size = T(1) / largest_component(axis.direction);
      n = inverse_size * axis.direction;
      turn = inverse_size * axis.turn;
      turning = largest_component(turn);
    }
    Vec3<T> n, turn;
    T turning;
  };

  /// How long all corners are proven beyond the separation, after `now` (`forward` 1) or before it (-1).
  T time_from(const T& now, const TurningAxis<T>& axis, const T& forward) const {
    const UnitAxis unit(axis);
    T least = select(unit.turning > T(0), T(1) / unit.turning, T(std::numeric_limits<double>::infinity()));
    for_each_corner_bound(now, unit, [&](const T& c0, const T& c1, const T& c2, const T& error_rate) {
      least = min(least, first_root(c0, forward * c1 - error_rate, c2));
    });
    return least;
  }

  /// visit(c0, c1, c2, error_rate) for each corner. The corner lies beyond the separation at now + x by at least c0 +
  /// c1 x - error_rate |x| + c2 x^2, while |x| times the turn is at most 1.
  template <class Visit>
  void for_each_corner_bound(const T& now, const UnitAxis& axis, const Visit& visit) const {
    constexpr double u = error_bounds::unit_roundoff<T>;
    const auto& [n, turn, turning] = axis;
    const T error = T(u) * size_ + T(error_bounds::underflow<T>);
    // The axis' length is at most |n| + (n.turn / |n|) x + (turn.turn / 2|n|) x^2, x = t - now. A square root lies
    // below its tangent.
    const T length = sqrt(dot(n, n));
    const T threshold = separation_ * length * T(1 + 8 * u) + T(error_bounds::kAxisNow) * error;
    const T slope = separation_ * (dot(n, turn) / length), bend = separation_ * (dot(turn, turn) / (T(2) * length));
    const T error_rate = T(error_bounds::kAxisLater) * error * (T(1) + turning);
    for (const auto& corner : corners_) {
      const Vec3<T> at = at_time(corner, now), velocity = corner.at1 - corner.at0;
      const T c0 = dot(n, at) - threshold, c1 = dot(n, velocity) + dot(turn, at) - slope;
      const T c2 = dot(turn, velocity) - bend;
      visit(c0, c1, c2, error_rate);
    }
  }

  Corners corners_;
  T separation_, size_;
};

}  // namespace tamis

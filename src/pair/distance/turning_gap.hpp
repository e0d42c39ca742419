// Tests whether a pair is proven to stay farther apart than a distance during some time. The axis turns at a constant
// rate from the closest points' gap at the start of that time to the gap at its end. Along it the pair's corners are
// quadratics in time. Their Bernstein coefficients bound them from below. So one axis proves a pair apart that turns as
// a whole. Error bound: kTurningGap. Cost: about 350 operations.
#pragma once
#include "numbers/assert.hpp"
#include "pair/distance/nearly_closest.hpp"
#include "pair/filters/filter.hpp"
#include "pair/motion/difference_corners.hpp"
#include "pair/motion/time_clip.hpp"

namespace tamis {

/// Parts into which the time is cut where one axis does not suffice.
inline constexpr int kTurningGapParts = 4;

template <PairKind kind, class T>
class TurningGap {
 public:
  /// A time, and a vector along the gap then, no longer than 1.
  struct Axis {
    T time;
    Vec3<T> along;
  };

  /// Keeps a reference. REQUIRES: `m` is the motion of the whole step, finite.
  explicit TurningGap(const PairMotion<T>& m) : m_(m) { TAMIS_ASSERT(is_whole(m)); }

  Vec3<T> gap(const T& t) const {
    return NearlyClosest::gap<kind>(at_time(m_.e, t), at_time(m_.f, t), at_time(m_.d, t));
  }
  /// The length, or more where squares underflow. Then an axis made with it is shorter than 1.
  static T length(const Vec3<T>& v) { return sqrt(max(dot(v, v), constant<T>(error_bounds::underflow<T>))); }
  static Axis axis(const T& t, const Vec3<T>& gap) { return {t, (T(1) / length(gap)) * gap}; }
  Axis at(const T& t) const { return axis(t, gap(t)); }

  /// True if the distance from one time in [0,1] to another is larger than `least`, less the error kTurningGap.
  Mask<T> exceeds(const T& least, const Axis& from, const Axis& until) const {
    const T half = constant<T>(0.5);
    T lowest = dot(from.along, at_time(m_.d, from.time));
    for (const auto& corner : difference_corners<kind>(m_)) {
      const Vec3<T> first = at_time(corner, from.time), last = at_time(corner, until.time);
      lowest = min(lowest, min(dot(from.along, first), dot(until.along, last)));
      lowest = min(lowest, half * (dot(from.along, last) + dot(until.along, first)));  // NaN if any axis is
    }
    return lowest > least;
  }

  /// The same, proven by one axis, or by one in each of `parts` equal parts of the time.
  Mask<T> exceeds(const T& least, Axis from, const T& until, int parts) const {
    const T share = constant<T>(1.0 / parts) * (until - from.time);
    Mask<T> result(true);
    for (int i = 1; i <= parts; ++i) {
      const Axis next = at(i < parts ? from.time + share : until);
      result = result & exceeds(least, from, next);
      if constexpr (std::is_same_v<Mask<T>, bool>)
        if (!result) return false;
      from = next;
    }
    return result;
  }

  /// True if the pair is proven farther apart than its separation during `time`.
  Mask<T> stays_apart(const TimeInterval<T>& time, int parts) const {
    return exceeds(least(), at(time.t_in), time.t_out, parts);
  }
  /// The argument of exceeds() that proves that.
  T least() const {
    return m_.separation + error_bounds::bound<T>(error_bounds::kTurningGap, m_.size_d + m_.size_e + m_.size_f);
  }

 private:
  const PairMotion<T>& m_;
};

}  // namespace tamis

// Does a pair certainly keep a fraction of its distance during some time? Along an axis that turns at a constant rate
// from the closest points' gap at the start of it to that at the end, the pair's corners are quadratics in time, whose
// Bernstein coefficients bound them from below; so a pair that turns as a whole is proven apart in one go.
// Error bound: kKeptGap. Cost: about 350 operations.
#pragma once
#include "numerics/error_bounds.hpp"
#include "solve/difference_corners.hpp"
#include "solve/nearly_closest.hpp"

namespace tamis {

template <PairKind kind, class T>
class KeptGap {
 public:
  /// A time, and a vector along the gap at it, not longer than 1.
  struct Axis {
    T time;
    Vec3<T> along;
  };

  /// `blur`: the pair may have been so much farther apart at t=0 than its vectors say.
  KeptGap(const PairMotion<T>& m, const T& fraction, const T& blur = T(0)) : m_(m) {
    const Vec3<T> gap = NearlyClosest::gap<kind>(m.e.at0, m.f.at0, m.d.at0);
    const T distance = length(gap);
    start_ = {T(0), (T(1) / distance) * gap};
    // Only pairs with room are left out: for these the advancement (keeps_distance_until) comes to the same result.
    const T room = error_bounds::constant<T>(error_bounds::kRoomToAdvance +
                                             error_bounds::kKeptGap * error_bounds::unit_roundoff<T>);
    kept_ =
        m.separation + fraction * max(distance + blur - m.separation, T(0)) + room * (m.size_d + m.size_e + m.size_f);
  }

  const Axis& start() const { return start_; }
  Axis at(const T& t) const {
    const Vec3<T> gap = NearlyClosest::gap<kind>(at_time(m_.e, t), at_time(m_.f, t), at_time(m_.d, t));
    return {t, (T(1) / length(gap)) * gap};
  }

  /// Is the distance proven to stay, from one time in [0,1] to another, beyond the separation, the fraction of its
  /// excess at t=0, and the room to advance?
  auto is_kept(const Axis& from, const Axis& until) const {
    const T half = error_bounds::constant<T>(0.5);
    T lowest = dot(from.along, at_time(m_.d, from.time));
    for (const auto& corner : difference_corners<kind>(m_)) {
      const Vec3<T> first = at_time(corner, from.time), last = at_time(corner, until.time);
      lowest = min(lowest, min(dot(from.along, first), dot(until.along, last)));
      lowest = min(lowest, half * (dot(from.along, last) + dot(until.along, first)));  // NaN if any axis is
    }
    return lowest > kept_;
  }

 private:
  /// At least; where squares underflow, axes are so shorter than 1.
  static T length(const Vec3<T>& v) {
    return sqrt(max(dot(v, v), error_bounds::constant<T>(error_bounds::underflow<T>)));
  }

  const PairMotion<T>& m_;
  Axis start_;
  T kept_;
};

}  // namespace tamis

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
  KeptGap(const PairMotion<T>& m, const T& fraction) : m_(m) {
    const T distance = length(NearlyClosest::gap<kind>(m.e.at0, m.f.at0, m.d.at0));
    // Only pairs with room are left out: for these the advancement (keeps_distance_until) comes to the same result.
    const T room = error_bounds::constant<T>(error_bounds::kRoomToAdvance +
                                             error_bounds::kKeptGap * error_bounds::unit_roundoff<T>);
    kept_ = m.separation + fraction * max(distance - m.separation, T(0)) + room * (m.size_d + m.size_e + m.size_f);
  }

  /// Is the distance proven to stay, from one time in [0,1] to another, beyond the separation, the fraction of its
  /// excess at t=0, and the room to advance?
  auto is_kept(const T& from, const T& until) const {
    const Vec3<T> n0 = axis_at(from), n1 = axis_at(until);
    const T half = error_bounds::constant<T>(0.5);
    T lowest = dot(n0, at_time(m_.d, from));
    for (const auto& corner : difference_corners<kind>(m_)) {
      const Vec3<T> first = at_time(corner, from), last = at_time(corner, until);
      lowest = min(lowest, min(dot(n0, first), dot(n1, last)));
      lowest = min(lowest, half * (dot(n0, last) + dot(n1, first)));  // NaN if any axis is
    }
    return lowest > kept_;
  }

 private:
  static T length(const Vec3<T>& v) { return sqrt(dot(v, v)); }

  Vec3<T> axis_at(const T& t) const {
    const Vec3<T> gap = NearlyClosest::gap<kind>(at_time(m_.e, t), at_time(m_.f, t), at_time(m_.d, t));
    return (T(1) / length(gap)) * gap;
  }

  const PairMotion<T>& m_;
  T kept_;
};

}  // namespace tamis

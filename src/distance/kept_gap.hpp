// Does a pair certainly keep a fraction of its distance during some time?
// Error bound: kKeptGap. Cost: that of a turning gap.
#pragma once
#include "distance/turning_gap.hpp"

namespace tamis {

template <PairKind kind, class T>
class KeptGap {
 public:
  /// `blur`: the pair may have been so much farther apart at t=0 than its vectors say.
  KeptGap(const PairMotion<T>& m, const T& fraction, const T& blur = T(0)) : gap_(m) {
    const Vec3<T> gap = gap_.gap(T(0));
    const T distance = TurningGap<kind, T>::length(gap);
    start_ = TurningGap<kind, T>::axis(T(0), gap);
    // Only pairs with room are left out: for these the advancement (keeps_distance_until) comes to the same result.
    const T room = error_bounds::constant<T>(error_bounds::kRoomToAdvance +
                                             error_bounds::kKeptGap * error_bounds::unit_roundoff<T>);
    kept_ =
        m.separation + fraction * max(distance + blur - m.separation, T(0)) + room * (m.size_d + m.size_e + m.size_f);
  }

  /// Is the distance proven to stay, from t=0 until a time in [0,1], beyond the separation, the fraction of its excess
  /// at t=0, and the room to advance? By one axis, or one in each of `parts` equal parts.
  auto is_kept(const T& until, int parts = 1) const { return gap_.exceeds(kept_, start_, until, parts); }

 private:
  const TurningGap<kind, T> gap_;
  typename TurningGap<kind, T>::Axis start_;
  T kept_;
};

}  // namespace tamis

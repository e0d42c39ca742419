// Tests whether a pair is proven to keep a fraction of its distance at t=0 until some time. Error bound: kKeptGap.
// Cost: as much as a turning gap.
#pragma once
#include "pair/distance/turning_gap.hpp"

namespace tamis {

template <PairKind kind, class T>
class KeptGap {
 public:
  /// `blur`: by how much the distance at t=0 may exceed what the vectors say.
  KeptGap(const PairMotion<T>& m, const T& fraction, const T& blur = T(0)) : gap_(m) {
    const Vec3<T> gap = gap_.gap(T(0));
    const T distance = TurningGap<kind, T>::length(gap);
    start_ = TurningGap<kind, T>::axis(T(0), gap);
    const T size = m.size_d + m.size_e + m.size_f;
    kept_ = m.separation + fraction * max(distance + blur - m.separation, T(0)) +
            constant<T>(error_bounds::kKeptGap * error_bounds::unit_roundoff<T>) * size;
    room_ = constant<T>(error_bounds::kAdvanceClearance) * size;
  }

  /// True if the distance is proven to exceed a sum until a time in [0,1]. The sum is the separation, the fraction of
  /// the clearance at t=0, and the advance clearance. By one axis, or by one in each of `parts` equal parts. With that
  /// clearance advancement (keeps_distance_until) gives the same result.
  auto is_kept(const T& until, int parts = 1) const { return gap_.exceeds(kept_ + room_, start_, until, parts); }

  /// True if the pair is proven to keep the fraction on the whole step. Needs no advance clearance. In doubles it is a
  /// part of keeps_distance_until, so the time of such a pair is 1 everywhere.
  auto is_kept_to_end(int parts = 1) const { return gap_.exceeds(kept_, start_, T(1), parts); }

 private:
  const TurningGap<kind, T> gap_;
  typename TurningGap<kind, T>::Axis start_;
  T kept_, room_;
};

}  // namespace tamis

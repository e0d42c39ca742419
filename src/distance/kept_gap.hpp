// Is a pair proven to keep a fraction of its distance at t=0 until some time?
// Error bound: kKeptGap. Cost: that of a turning gap.
#pragma once
#include "distance/turning_gap.hpp"

namespace tamis {

template <PairKind kind, class T>
class KeptGap {
 public:
  /// `blur`: by how much the distance at t=0 may exceed what the vectors say.
  KeptGap(const PairMotion<T>& m, const T& fraction, const T& blur = T(0)) : gap_(m) {
    const Vec3<T> gap = gap_.gap(T(0));
    const T distance = TurningGap<kind, T>::length(gap);
    start_ = TurningGap<kind, T>::axis(T(0), gap);
    // Only pairs with this clearance are left out: for these advancement (keeps_distance_until) gives the same result.
    const T clearance =
        constant<T>(error_bounds::kAdvanceClearance + error_bounds::kKeptGap * error_bounds::unit_roundoff<T>);
    kept_ = m.separation + fraction * max(distance + blur - m.separation, T(0)) +
            clearance * (m.size_d + m.size_e + m.size_f);
  }

  /// Is the distance proven to exceed, until a time in [0,1], the sum of the separation, the fraction of its clearance
  /// at t=0 and the advance clearance? By one axis, or by one in each of `parts` equal parts.
  auto is_kept(const T& until, int parts = 1) const { return gap_.exceeds(kept_, start_, until, parts); }

 private:
  const TurningGap<kind, T> gap_;
  typename TurningGap<kind, T>::Axis start_;
  T kept_;
};

}  // namespace tamis

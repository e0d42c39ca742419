// One step of conservative advancement for a minimum separation. It tells whether the pair is within the separation at
// a time. If not, it tells until when the pair is certainly apart. The next time to probe is the end of that proof:
// Newton's method on the distance, from the safe side. Double and SIMD lanes run the same code. So a pair has the same
// bits in both.
#pragma once
#include "numbers/assert.hpp"
#include "pair/distance/orthogonal_axis.hpp"
#include "pair/filters/filter.hpp"

namespace tamis {

/// Advances shorter than this, as a fraction of the time step, do not count as progress.
inline constexpr double kShortestAdvance = 0x1p-50;

/// The distance at one time.
template <class T>
struct DistanceAt {
  ClosestPointsOf<T> closest;
  T length;   ///< of their gap
  T at_most;  ///< a proven upper bound of the distance
};

/// How long a pair is proven apart from the probed time on.
template <class T>
struct ApartProof {
  T until;              ///< proven apart until then; no later than the probed time if nothing is proven
  T retry_in;           ///< after this time the distance should have fallen far enough to certify a contact
  TurningAxis<T> axis;  ///< along which the pair is apart
};

/// Keeps a reference. REQUIRES: `m` is the motion of the whole step, finite.
template <PairKind kind, class T>
class SeparationProbe {
 public:
  explicit SeparationProbe(const PairMotion<T>& m)
      : m_(m), clip_(m), error_(error_bounds::bound<T>(error_bounds::kGap, m.size_d + m.size_e + m.size_f)) {
    TAMIS_ASSERT(is_whole(m));
  }

  DistanceAt<T> distance_at(const T& t) const {
    const auto closest = closest_points<kind>(at_time(m_.e, t), at_time(m_.f, t), at_time(m_.d, t));
    const T length = sqrt(dot(closest.gap, closest.gap));
    return {closest, length, length * T(error_bounds::kLengthUp) + error_};
  }
  /// True if the distance is certified to be within the separation.
  Mask<T> touches(const DistanceAt<T>& distance) const { return distance.at_most <= m_.separation; }

  /// The proof that the pair is apart from `t` on. `distance`: distance_at(t).
  ApartProof<T> prove_apart(const T& t, const DistanceAt<T>& distance) const {
    const TurningAxis<T> fixed{distance.closest.gap}, turning = orthogonal_axis<kind>(m_, t, distance.closest);
    const T by_fixed = clip_.apart_until(t, fixed), by_turning = clip_.apart_until(t, turning);
    const auto is_fixed = by_fixed >= by_turning;
    return {select(is_fixed, by_fixed, by_turning),
            retry_in(distance.closest, distance.length, distance.at_most - m_.separation),
            {select(is_fixed, fixed.direction, turning.direction), select(is_fixed, fixed.turn, turning.turn)}};
  }

  const AxisClip<kind, T>& clip() const { return clip_; }

 private:
  /// Twice the time that the closest points, if they were fixed, would need to come closer by `excess`.
  T retry_in(const ClosestPointsOf<T>& closest, const T& length, const T& excess) const {
    const Vec3<T> change = gap_at<kind>(m_.e.at1, m_.f.at1, m_.d.at1, closest.u, closest.v) -
                           gap_at<kind>(m_.e.at0, m_.f.at0, m_.d.at0, closest.u, closest.v);
    const T closing = -dot(closest.gap, change) / length;
    const T time = min(max(T(2) * excess / closing, T(kShortestAdvance)), T(0x1p-10));
    return select(closing > T(0), time, T(0x1p-40));
  }

  const PairMotion<T>& m_;
  const AxisClip<kind, T> clip_;
  const T error_;
};

/// Where an advancement stands: all before `now` is decided, and `now + ahead` is probed next.
template <class T>
struct Advancement {
  T now, ahead = T(0);

  /// Where `is_apart`: the pair is proven apart until `proof.until`, and advances to there.
  void advance(const Mask<T>& is_apart, const ApartProof<T>& proof) {
    const auto is_stuck = proof.until - now <= T(kShortestAdvance);
    now = select(is_apart, proof.until, now);
    ahead = select(is_apart, select(is_stuck, proof.retry_in, T(0)), ahead);
  }
  /// Where `is_unsure`: doubles cannot tell at this time. Probes later and later, until the answer is clear.
  void retry_later(const Mask<T>& is_unsure, const ApartProof<T>& proof) {
    ahead = select(is_unsure, select(ahead > T(0), T(2) * ahead, proof.retry_in), ahead);
  }
};

}  // namespace tamis

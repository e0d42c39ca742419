// Minimum separation, one look at one time: is the pair within it, and if not, until when is it certainly apart? Looks
// follow each other as Newton's method on the distance would have it, from the safe side. For double and for SIMD
// lanes, so that a pair has the same bits however it is asked.
#pragma once
#include "distance/squared_axis.hpp"
#include "filters/filter.hpp"
#include "numerics/assert.hpp"

namespace tamis {

/// Steps shorter than this, as a fraction of the step of time, are no progress.
inline constexpr double kShortestStride = 0x1p-50;

/// The closest points at one time.
template <class T>
struct Sight {
  ClosestPointsOf<T> closest;
  T length;    ///< of their gap
  T farthest;  ///< what the distance is at most
};

/// Where a pair is not within its separation, as far as doubles can tell.
template <class T>
struct Look {
  T until;              ///< proven apart until then; no later than the time of the look if not even there
  T wait;               ///< after this time the distance should have fallen far enough to be certified
  TurningAxis<T> axis;  ///< along which it is apart
};

/// Keeps a reference. REQUIRES: `m` is the motion of the whole step, finite.
template <PairKind kind, class T>
class Looker {
 public:
  explicit Looker(const PairMotion<T>& m)
      : m_(m), clip_(m), error_(error_bounds::bound<T>(error_bounds::kGap, m.size_d + m.size_e + m.size_f)) {
    TAMIS_ASSERT(is_whole(m));
  }

  Sight<T> sight(const T& t) const {
    const auto closest = closest_points<kind>(at_time(m_.e, t), at_time(m_.f, t), at_time(m_.d, t));
    const T length = sqrt(dot(closest.gap, closest.gap));
    return {closest, length, length * T(error_bounds::kLengthUp) + error_};
  }
  /// Is the distance within the separation, certified?
  Mask<T> touches(const Sight<T>& sight) const { return sight.farthest <= m_.separation; }

  /// `sight` is that at `t`.
  Look<T> at(const T& t, const Sight<T>& sight) const {
    const TurningAxis<T> fixed{sight.closest.gap}, turning = squared_axis<kind>(m_, t, sight.closest);
    const T by_fixed = clip_.apart_until(t, fixed), by_turning = clip_.apart_until(t, turning);
    const auto is_fixed = by_fixed >= by_turning;
    return {select(is_fixed, by_fixed, by_turning),
            wait(sight.closest, sight.length, sight.farthest - m_.separation),
            {select(is_fixed, fixed.direction, turning.direction), select(is_fixed, fixed.turn, turning.turn)}};
  }

  const AxisClip<kind, T>& clip() const { return clip_; }

 private:
  /// Twice the time in which the closest points, were they fixed, would come closer by `excess`.
  T wait(const ClosestPointsOf<T>& closest, const T& length, const T& excess) const {
    const Vec3<T> change = gap_at<kind>(m_.e.at1, m_.f.at1, m_.d.at1, closest.u, closest.v) -
                           gap_at<kind>(m_.e.at0, m_.f.at0, m_.d.at0, closest.u, closest.v);
    const T closing = -dot(closest.gap, change) / length;
    const T time = min(max(T(2) * excess / closing, T(kShortestStride)), T(0x1p-10));
    return select(closing > T(0), time, T(0x1p-40));
  }

  const PairMotion<T>& m_;
  const AxisClip<kind, T> clip_;
  const T error_;
};

/// Where an advancement stands: all before `now` is decided, and `now + ahead` is looked at next.
template <class T>
struct Advancement {
  T now, ahead = T(0);

  /// Where `goes`: proven apart until `look.until`.
  void pass(const Mask<T>& goes, const Look<T>& look) {
    const auto is_stuck = look.until - now <= T(kShortestStride);
    now = select(goes, look.until, now);
    ahead = select(goes, select(is_stuck, look.wait, T(0)), ahead);
  }
  /// Where `waits`: doubles cannot tell at this time; later, until the answer is clear.
  void wait(const Mask<T>& waits, const Look<T>& look) {
    ahead = select(waits, select(ahead > T(0), T(2) * ahead, look.wait), ahead);
  }
};

}  // namespace tamis

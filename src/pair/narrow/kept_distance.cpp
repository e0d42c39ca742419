#include "pair/narrow/kept_distance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numbers/assert.hpp"
#include "pair/distance/kept_gap.hpp"
#include "pair/distance/orthogonal_axis.hpp"
#include "pair/exact/start_distance.hpp"
#include "pair/motion/difference_corners.hpp"
#include "pair/motion/pair_kinds.hpp"
#include "pair/narrow/decide.hpp"
#include "pair/narrow/first_within.hpp"

namespace tamis {
namespace {

using Vec = Vec3<double>;

using error_bounds::kRoundoff;
/// The distance at t=0 must be known to this fraction of the clearance. Else it is decided in integers.
constexpr double kSharpEnough = 0x1p-20;

/// Proven bounds, in the unit of the motion.
struct StartBounds {
  double low, high;  ///< the distance at t=0
  double speed;      ///< at least the speed of any point of one feature against any of the other
};

/// A lower bound, beyond all rounding, of the distance at t=0, along the gap of the closest points. Rounding tilts a
/// small gap. Then the bound is also taken along the gap made orthogonal to the features.
template <PairKind kind>
double start_distance_bound(const PairMotion<double>& m, const ClosestPoints& closest) {
  constexpr double kSharp = 1 - 0x1p-40;
  const AxisClip<kind, double> clip(m);
  const double along_gap = clip.distance_along(0.0, closest.gap);
  if (along_gap >= kSharp * std::sqrt(dot(closest.gap, closest.gap))) return along_gap;
  return std::max(along_gap, clip.distance_along(0, orthogonal_axis<kind>(m, 0.0, closest).direction));
}

/// REQUIRES: the motion of the whole step, finite.
StartBounds start_bounds(PairKind kind, const PairMotion<double>& m) {
  TAMIS_ASSERT(is_whole(m));
  const double size = m.size_d + m.size_e + m.size_f;
  return with_kind(kind, [&](auto k) -> StartBounds {
    const ClosestPoints closest = closest_points<k()>(m.e.at0, m.f.at0, m.d.at0);
    const double high = std::sqrt(dot(closest.gap, closest.gap)) * error_bounds::kLengthUp +
                        error_bounds::bound(error_bounds::kGap, size);
    const double speed =
        std::sqrt(squared_speed<k()>(m)) * error_bounds::kLengthUp + error_bounds::bound(error_bounds::kVelocity, size);
    return {start_distance_bound<k()>(m, closest), high, speed};
  });
}

/// The distance that must be kept where the one at t=0 is `distance`; `rounding`: 1 for an upper bound, -1 for a lower.
double kept(double distance, const PairMotion<double>& m, double fraction, int rounding) {
  const double clearance = std::max(distance - m.separation, 0.0);
  return (m.separation + fraction * clearance) * (1 + rounding * 8 * kRoundoff);
}

/// The time until which a pair without clearance at t=0 obeys the rule. Less than 1 if it comes back, even at t=1.
double keeps_without_clearance_until(PairKind kind, const PairPoints& points, const DistanceRule& rule,
                                     PrecisionCount& decided_by) {
  if (!rule.ignores_start) return 0;
  const PairResult again = decide_recontact({kind, points, rule.min_separation}, decided_by);
  return again.touches ? std::min(again.toi_lower, 1 - kRoundoff) : 1;
}

/// Proves pairs that advancement may lose to rounding. Lanes prove the same (search/kernels/step_length_kernels.hpp).
bool is_kept_to_end(PairKind kind, const PairMotion<double>& m, double fraction) {
  return with_kind(kind, [&](auto k) {
    if constexpr (can_cross(k())) {
      const KeptGap<k(), double> gap(m, fraction);
      return gap.is_kept_to_end() || gap.is_kept_to_end(kTurningGapParts);
    }
    return false;
  });
}

}  // namespace

double keeps_distance_until(PairKind kind, const PairPoints& points, const DistanceRule& rule, double until,
                            PrecisionCount& decided_by) {
  TAMIS_ASSERT(0 < rule.fraction && rule.fraction < 1);
  PairMotion<double> m = make_motion(kind, points, rule.min_separation);
  const StartBounds start = start_bounds(kind, m);
  const bool is_within = start.high <= m.separation;  // certified
  const double clearance = start.low - m.separation, portion = (1 - rule.fraction) * (1 - 4 * kRoundoff);
  const bool is_sharp = start.high - start.low <= kSharpEnough * clearance;
  ++(is_within || is_sharp ? decided_by.scalar : decided_by.exact);
  if (is_within) return keeps_without_clearance_until(kind, points, rule, decided_by);
  const double by_speed = is_sharp ? portion * (clearance / start.speed) * (1 - 4 * kRoundoff)
                                   : portion * apart_from_start(kind, points, rule.min_separation);
  until = std::min(until, 1.0);
  // A pair that stands still loses nothing. This holds even where rounding exceeds the part of its distance that it may
  // lose.
  const bool stands_still = by_speed < until && points.start == points.end;
  if (by_speed == 0 && (rule.ignores_start || stands_still) &&
      starts_within(kind, points, rule.min_separation))  // else by_speed has underflowed
    return keeps_without_clearance_until(kind, points, rule, decided_by);
  if (stands_still) return 1;
  if (by_speed == 0 || by_speed >= until) return std::min(by_speed, 1.0);
  const double separation = std::exchange(m.separation, kept(start.high, m, rule.fraction, 1));
  const double time = apart_until(kind, m, by_speed, until);
  if (time >= until) return time;
  m.separation = separation;
  return is_kept_to_end(kind, m, rule.fraction) ? 1 : time;
}

double fraction_is_left_at(PairKind kind, const PairPoints& points, const DistanceRule& rule, double lower) {
  TAMIS_ASSERT(0 < rule.fraction && rule.fraction < 1 && 0 <= lower && lower <= 1);
  if (lower == 0) return starts_within(kind, points, rule.min_separation) ? 0 : 1;
  PairMotion<double> m = make_motion(kind, points, rule.min_separation);
  m.separation = kept(start_bounds(kind, m).low, m, rule.fraction, -1);
  const Decision decision = first_within(kind, m, {lower, 1});
  return decision.touches() ? decision.upper : 1;
}

DistanceBounds start_distance_bounds(PairKind kind, const PairPoints& points) {
  const PairMotion<double> m = make_motion(kind, points, 1);  // the separation 1 becomes the unit of the motion
  const StartBounds start = start_bounds(kind, m);
  return {std::max(start.low / m.separation * (1 - 4 * kRoundoff), 0.0),
          start.high / m.separation * (1 + 4 * kRoundoff)};
}

}  // namespace tamis

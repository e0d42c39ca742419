// Finds recontacts in doubles. A pair that is within its separation at t=0 may leave it and come back. Runs for each
// such pair where contacts at the start are ignored.
#include <algorithm>
#include <cmath>

#include "pair/distance/orthogonal_axis.hpp"
#include "pair/motion/difference_corners.hpp"
#include "pair/narrow/advancement.hpp"
#include "pair/narrow/decisions.hpp"
#include "pair/narrow/first_within.hpp"

namespace tamis {
namespace {

/// Iterations of the search for the time of leaving. Halvings of a time during which the pair must stay within.
constexpr int kMaxLeavingProbes = 16, kMostHalvings = 10;

template <PairKind kind>
class Recontact {
 public:
  explicit Recontact(const PairMotion<double>& m)
      : m_(m), probe_(m), corners_(difference_corners<kind>(m)), size_(m.size_d + m.size_e + m.size_f) {}

  std::optional<Decision> run() {
    const Probed start = probed_at(0), end = probed_at(1);
    if (!start.touches) return {};
    if (!end.touches) return after_leaving(start, end);
    return stays_within(start, end, kMostHalvings) ? std::optional(Decision{}) : std::nullopt;
  }

 private:
  struct Probed {
    double time;
    DistanceAt<double> distance;
    bool touches;
  };

  Probed probed_at(double time) const {
    const DistanceAt<double> distance = probe_.distance_at(time);
    return {time, distance, probe_.touches(distance)};
  }

  /// True if the pair is certified to be apart at that time.
  bool is_apart(const Probed& at) const { return probe_.prove_apart(at.time, at.distance).until > at.time; }

  /// An upper bound of the distance at `time`, from two points of the features with fixed weights. The vector between
  /// these is linear in time. So between two times it is no longer than at one of them.
  double distance_at_most(double time, const ClosestPoints& points) const {
    const Vec3<double> gap =
        gap_at<kind>(at_time(m_.e, time), at_time(m_.f, time), at_time(m_.d, time), points.u, points.v);
    return std::sqrt(dot(gap, gap)) * error_bounds::kLengthUp + error_bounds::bound(error_bounds::kGap, size_);
  }

  /// True if the pair is proven within its separation from `from` until `until`. REQUIRES: it touches at both.
  bool stays_within(const Probed& from, const Probed& until, int halvings) const {
    if (distance_at_most(from.time, until.distance.closest) <= m_.separation) return true;
    if (distance_at_most(until.time, from.distance.closest) <= m_.separation) return true;
    if (halvings == 0) return false;
    const Probed middle = probed_at(0.5 * (from.time + until.time));
    return middle.touches && stays_within(from, middle, halvings - 1) && stays_within(middle, until, halvings - 1);
  }

  /// Brackets the time at which the pair leaves between `last`, which touches, and `next`, which seems not to; then
  /// searches the rest of the step.
  std::optional<Decision> after_leaving(const Probed& start, Probed next) const {
    Probed last = start;
    for (int probes = 0; !grows(last.time, next.time); ++probes) {
      const double first = last.distance.length - m_.separation, then = next.distance.length - m_.separation;
      const double part = std::clamp(first / (first - then), 0.125, 0.875);
      Probed now = probed_at((1 - part) * last.time + part * next.time);
      // A pair that parts steadily is at its separation there, neither within it nor proven apart.
      if (!now.touches && !is_apart(now)) now = probed_at(0.5 * (now.time + next.time));
      if (probes == kMaxLeavingProbes || !(last.time < now.time && now.time < next.time)) return {};
      (now.touches ? last : next) = now;
    }
    if (!is_apart(next) || !stays_within(start, last, kMostHalvings)) return {};
    return first_within(kind, m_, {next.time, 1});
  }

  /// True if the distance is proven to grow throughout. Then the pair leaves its separation once at most. Proof:
  /// docs/numerics/distances.md, "Ignored at the start".
  bool grows(double from, double until) const {
    const double middle = 0.5 * (from + until);
    const ClosestPoints closest = probe_.distance_at(middle).closest;
    const TurningAxis<double> axis = orthogonal_axis<kind>(m_, middle, closest);
    const double scale = 1 / largest_component(axis.direction);
    Growth growth{scale * axis.direction, scale * axis.turn};
    const double most = std::max(distance_at_most(from, closest), distance_at_most(until, closest));
    const double least =
        std::min(probe_.clip().distance_along(from, growth.n), probe_.clip().distance_along(until, growth.n));
    const double length = std::sqrt(dot(growth.n, growth.n)) * kUp;
    // Two unit vectors have |a - b|^2 = 2 - 2 a.b. The terms with 2^-46 cover the rounding here.
    growth.tilt = std::sqrt(2 * (1 - least / most) + 0x1p-46) * length;
    growth.reach = most * length * kUp;
    growth.sideways = std::sqrt((most - least) * (most + least) + 0x1p-46 * most * most);
    growth.least_gain =
        (std::sqrt(dot(growth.turn, growth.turn)) * growth.sideways + most * std::fabs(dot(growth.turn, growth.n))) *
            kUp +
        error_bounds::bound(error_bounds::kGrowth, size_ * (1 + largest_component(growth.turn)));
    return least > 0 && std::all_of(corners_.begin(), corners_.end(), [&](const Moving<double>& corner) {
             const Vec3<double> first = at_time(corner, from), last = at_time(corner, until);
             return (growth.is_beyond(first, size_) && growth.is_beyond(last, size_)) ||
                    gains(corner, first, last, growth);
           });
  }

  /// Facts that hold during a time, about the direction between the closest points and about the nearest point. The
  /// nearest point is the point of the Minkowski difference nearest to zero.
  struct Growth {
    Vec3<double> n, turn;   ///< a direction with the largest component 1, and the rate at which it should turn
    double tilt = 0;        ///< the unit direction between closest points, times |n|, differs from n by no more
    double reach = 0;       ///< the distance, times |n|, is no larger
    double sideways = 0;    ///< the nearest point is no farther from the line along n
    double least_gain = 0;  ///< the most that turning with n, and all rounding, can take from a corner's gain

    /// True if the corner is too far along the direction to take part in the nearest point.
    bool is_beyond(const Vec3<double>& corner, double size) const {
      const double error = error_bounds::bound(error_bounds::kAxisNow, size);
      return dot(n, corner) - error > (reach + tilt * (std::sqrt(dot(corner, corner)) + error)) * kUp;
    }
  };

  /// True if the corner moves away along the turning axis faster than the axis' possible tilt could hide.
  bool gains(const Moving<double>& corner, const Vec3<double>& first, const Vec3<double>& last,
             const Growth& growth) const {
    const Vec3<double> velocity = corner.at1 - corner.at0;
    const double speed = std::sqrt(dot(velocity, velocity)) + error_bounds::bound(error_bounds::kVelocity, size_);
    const double gain = dot(growth.n, velocity) + std::min(dot(growth.turn, first), dot(growth.turn, last));
    return gain > (growth.least_gain + growth.tilt * speed) * kUp;
  }

  static constexpr double kUp = 1 + 32 * error_bounds::kRoundoff;

  const PairMotion<double>& m_;
  const SeparationProbe<kind, double> probe_;
  const decltype(difference_corners<kind>(PairMotion<double>{})) corners_;
  const double size_;
};

}  // namespace

std::optional<Decision> first_recontact_within(PairKind kind, const PairMotion<double>& m) {
  TAMIS_ASSERT(is_whole(m) && m.separation > 0);
  return with_kind(kind, [&](auto k) { return Recontact<k()>(m).run(); });
}

}  // namespace tamis

#include "narrow/leaving.hpp"

#include <algorithm>
#include <cmath>

#include "distance/difference_corners.hpp"
#include "narrow/advancement.hpp"
#include "narrow/separation.hpp"

namespace tamis {
namespace {

/// Times at which the time of leaving is looked for, and halvings of a time during which the pair is to stay.
constexpr int kMostLooks = 24, kMostHalvings = 6;

template <PairKind kind>
class Leaving {
 public:
  explicit Leaving(const PairMotion<double>& m)
      : m_(m), looker_(m), corners_(difference_corners<kind>(m)), size_(m.size_d + m.size_e + m.size_f) {}

  bool run() {
    const Seen start = at(0), end = at(1);
    if (!start.touches) return false;
    return end.touches ? stays(start, end, kMostHalvings) : leaves(start, end);
  }

 private:
  struct Seen {
    double time;
    Sight<double> sight;
    bool touches;
  };

  Seen at(double time) const {
    const Sight<double> sight = looker_.sight(time);
    return {time, sight, looker_.touches(sight)};
  }

  /// What the distance at `time` is at most, by two points of the features. Between two times the way from the one
  /// point to the other changes linearly: it is no longer than at one of them.
  double farthest(double time, const ClosestPoints& points) const {
    const Vec3<double> gap =
        gap_at<kind>(at_time(m_.e, time), at_time(m_.f, time), at_time(m_.d, time), points.u, points.v);
    return std::sqrt(dot(gap, gap)) * error_bounds::kLengthUp + error_bounds::bound(error_bounds::kGap, size_);
  }

  /// Within the separation all the time. Both touch.
  bool stays(const Seen& from, const Seen& until, int halvings) const {
    if (farthest(from.time, until.sight.closest) <= m_.separation) return true;
    if (farthest(until.time, from.sight.closest) <= m_.separation) return true;
    if (halvings == 0) return false;
    const Seen middle = at(0.5 * (from.time + until.time));
    return middle.touches && stays(from, middle, halvings - 1) && stays(middle, until, halvings - 1);
  }

  /// `last` touches, `next` does not; both come nearer to the time between them at which the pair leaves.
  bool leaves(const Seen& start, Seen next) const {
    Seen last = start;
    for (int looks = 0; !leaves_once(last.time, next.time); ++looks) {
      const double first = last.sight.length - m_.separation, then = next.sight.length - m_.separation;
      const double part = std::clamp(first / (first - then), 0.125, 0.875);
      const Seen now = at((1 - part) * last.time + part * next.time);
      if (looks == kMostLooks || !(last.time < now.time && now.time < next.time)) return false;
      (now.touches ? last : next) = now;
    }
    return stays(start, last, kMostHalvings) && first_within(kind, m_, {next.time, 1}).verdict == Verdict::is_free;
  }

  /// During this time, once the pair is beyond its separation it stays there. Whatever the time t of that, the
  /// direction n(t) of the closest points is within `tilt` of a fixed one; and along n(t) each corner of the difference
  /// moves on, or is far off.
  bool leaves_once(double from, double until) const {
    const ClosestPoints closest = looker_.sight(0.5 * (from + until)).closest;
    const Vec3<double> n = (1 / largest_component(closest.gap)) * closest.gap;
    const double length = std::sqrt(dot(n, n)) * error_bounds::kLengthUp;
    const double most = std::max(farthest(from, closest), farthest(until, closest));
    const double least = std::min(looker_.clip().distance_along(from, n), looker_.clip().distance_along(until, n));
    // |n(t) - n|^2 = 2 - 2 cos, of unit vectors; n has a margin for the rounding here.
    const double tilt = std::sqrt(2 * (1 - least / most) + 0x1p-46) * length;
    return least > 0 && std::all_of(corners_.begin(), corners_.end(), [&](const Moving<double>& corner) {
             return moves_on(corner, n, tilt) || (is_beyond(at_time(corner, from), n, tilt, length) &&
                                                  is_beyond(at_time(corner, until), n, tilt, length));
           });
  }

  static constexpr double kUp = 1 + 16 * error_bounds::kRoundoff;

  bool moves_on(const Moving<double>& corner, const Vec3<double>& n, double tilt) const {
    const Vec3<double> velocity = corner.at1 - corner.at0;
    const double speed = std::sqrt(dot(velocity, velocity)) * kUp + error_bounds::bound(error_bounds::kVelocity, size_);
    return dot(n, velocity) - error_bounds::bound(error_bounds::kVelocityAlong, size_) >= tilt * speed * kUp;
  }
  bool is_beyond(const Vec3<double>& corner, const Vec3<double>& n, double tilt, double length) const {
    const double reach = std::sqrt(dot(corner, corner)) * kUp + error_bounds::bound(error_bounds::kGap, size_);
    return dot(n, corner) - error_bounds::bound(error_bounds::kAxisNow, size_) >
           (m_.separation * length + tilt * reach) * kUp;
  }

  const PairMotion<double>& m_;
  const Looker<kind, double> looker_;
  const decltype(difference_corners<kind>(PairMotion<double>{})) corners_;
  const double size_;
};

}  // namespace

bool touches_until_it_leaves(PairKind kind, const PairMotion<double>& m) {
  TAMIS_ASSERT(is_whole(m));
  return m.separation > 0 && with_kind(kind, [&](auto k) { return Leaving<k()>(m).run(); });
}

}  // namespace tamis

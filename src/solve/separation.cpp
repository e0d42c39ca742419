#include "solve/separation.hpp"

#include <algorithm>
#include <optional>

#include "motion/pair_kinds.hpp"
#include "solve/apart_times.hpp"
#include "solve/closest.hpp"

namespace tamis {
namespace {

using Vec = Vec3<double>;

/// Steps shorter than this, as a fraction of the step of time, are no progress.
constexpr double kShortest = 0x1p-50;
/// Looks at one pair. Newton's method needs 3 to 8; a near miss by 1e-15 of the pair's size needs about 40.
constexpr int kMaxLooks = 160;
/// Looks that bring so much of the step do not count: a pair with room (error_bounds::kRoomToAdvance) has no others.
constexpr double kLongStride = error_bounds::kRoomToAdvance / 16;

/// The sides of the two features that hold the closest points in their inside: none, one, or e and f.
struct ActiveSides {
  int count = 0;
  Vec side{0, 0, 0}, velocity{0, 0, 0};  ///< if there is one
};

template <PairKind kind>
ActiveSides active_sides(const PairMotion<double>& m, double t, const ClosestPoints& closest) {
  const double u = closest.u, v = closest.v;
  const auto one = [&](const Moving<double>& side) { return ActiveSides{1, at_time(side, t), side.at1 - side.at0}; };
  const bool inside_e = u > 0 && u<1, inside_f = v> 0 && v < 1;
  if constexpr (kind == PairKind::vertex_face) {
    if (u > 0 && v > 0) return u + v < 1 ? ActiveSides{2} : one(m.f - m.e);
  } else {
    if (inside_e && inside_f) return {2};
  }
  return inside_e ? one(m.e) : inside_f ? one(m.f) : ActiveSides{};
}

/// The axis of the closest points, made orthogonal to the sides that hold them: the gap is off by a few u of the
/// features' size, not of its own, which would tilt the axis of a small gap. It turns so that it stays orthogonal.
template <PairKind kind>
TurningAxis squared_axis(const PairMotion<double>& m, double t, const ClosestPoints& closest) {
  const Vec e = at_time(m.e, t), f = at_time(m.f, t), axis = squared_gap<kind>(e, f, closest);
  const ActiveSides active = active_sides<kind>(m, t, closest);
  if (active.count == 0) return {axis};
  if (active.count == 1) {
    const double inverse_square = 1 / dot(active.side, active.side);
    return {axis, -(dot(axis, active.velocity) * inverse_square) * active.side};
  }
  // turn = x e + y f such that turn.e = -axis.e' and turn.f = -axis.f'.
  const double turn_e = -dot(axis, m.e.at1 - m.e.at0), turn_f = -dot(axis, m.f.at1 - m.f.at0);
  const double ee = dot(e, e), ef = dot(e, f), ff = dot(f, f), inverse = 1 / dot(axis, axis);
  return {axis, (inverse * (ff * turn_e - ef * turn_f)) * e + (inverse * (ee * turn_f - ef * turn_e)) * f};
}

/// What one look at one time tells.
struct Look {
  bool touches;      ///< the distance is within the separation, certified
  ApartTimes apart;  ///< proven; empty if this very time could not be proven apart
  double wait;       ///< after this time the distance should have fallen far enough to be certified
};

template <PairKind kind>
class Looker {
 public:
  explicit Looker(const PairMotion<double>& m)
      : m_(m), clip_(m), error_(error_bounds::bound(error_bounds::kGap, m.size_d + m.size_e + m.size_f)) {}

  Look at(double t) const {
    const Vec e = at_time(m_.e, t), f = at_time(m_.f, t), d = at_time(m_.d, t);
    const ClosestPoints closest = closest_points(kind, e, f, d);
    const double farthest = std::sqrt(dot(closest.gap, closest.gap)) * error_bounds::kLengthUp + error_;
    if (farthest <= m_.separation) return {true, {2, -1}, 0};
    ApartTimes apart = clip_.around(t, {closest.gap});
    const ApartTimes turning = clip_.around(t, squared_axis<kind>(m_, t, closest));
    if (turning.contains(t) && !(apart.contains(t) && apart.to >= turning.to)) apart = turning;
    return {false, apart, wait(closest, farthest - m_.separation)};
  }

 private:
  /// Twice the time in which the closest points, were they fixed, would come closer by `excess`.
  double wait(const ClosestPoints& closest, double excess) const {
    const auto gap = [&](const Vec& e, const Vec& f, const Vec& d) {
      return kind == PairKind::edge_edge ? d + closest.v * f - closest.u * e : d - (closest.u * e + closest.v * f);
    };
    const Vec change = gap(m_.e.at1, m_.f.at1, m_.d.at1) - gap(m_.e.at0, m_.f.at0, m_.d.at0);
    const double length = std::sqrt(dot(closest.gap, closest.gap));
    const double closing = -dot(closest.gap, change) / length;
    return closing > 0 ? std::clamp(2 * excess / closing, kShortest, 0x1p-10) : 0x1p-40;
  }

  const PairMotion<double>& m_;
  const AxisClip<kind> clip_;
  const double error_;
};

/// Goes through the step from its start. Until `now_` everything is settled.
template <PairKind kind>
class Advance {
 public:
  Advance(const PairMotion<double>& m, const TimeInterval<double>& time)
      : looker_(m), end_(time.t_out), now_(time.t_in) {}

  Decision run() {
    for (int looks = 0; looks < kMaxLooks && now_ <= end_;) {
      const double before = now_, t = std::min(now_ + ahead_, end_);
      const Look look = looker_.at(t);
      if (look.touches) return touching(t);
      if (look.apart.contains(t))
        pass(look);
      else
        wait(look, t);
      if (now_ - before < kLongStride) ++looks;
    }
    if (now_ <= end_) add_unsure(end_);
    return decision_;
  }

 private:
  /// A time proven apart: everything up to the end of that proof is settled, or all but a part before it.
  void pass(const Look& look) {
    if (look.apart.from >= now_) {
      beyond_ = look.apart;
      ahead_ = 0.5 * (beyond_->from - now_);
      if (ahead_ > kShortest) return;
      add_unsure(beyond_->from);
    }
    const bool is_stuck = look.apart.to - now_ <= kShortest;
    settle(look.apart.to);
    if (is_stuck) ahead_ = look.wait;
  }

  /// A time at which doubles cannot tell: look later, until the answer is clear.
  void wait(const Look& look, double t) {
    if (beyond_) {
      add_unsure(beyond_->from);
      settle(beyond_->to);
    } else if (t >= end_) {
      add_unsure(end_);
      settle(2);
    } else {
      ahead_ = ahead_ > 0 ? 2 * ahead_ : look.wait;
    }
  }

  void settle(double until) {
    now_ = until;
    ahead_ = 0;
    beyond_.reset();
  }

  void add_unsure(double until) {
    if (decision_.verdict == Verdict::is_free) decision_ = {Verdict::unsure, now_, until};
    decision_.upper = until;
  }

  Decision touching(double t) const {
    return {Verdict::touches, decision_.verdict == Verdict::is_free ? now_ : decision_.lower, t};
  }

  const Looker<kind> looker_;
  const double end_;
  double now_, ahead_ = 0;
  std::optional<ApartTimes> beyond_;  ///< proven apart again, after times that are not
  Decision decision_;
};

template <PairKind kind>
double apart_until(const PairMotion<double>& m, double from, double until) {
  const Looker<kind> looker(m);
  double now = from;
  for (int looks = 0; looks < kMaxLooks && now < until;) {
    const Look look = looker.at(now);
    if (!look.apart.contains(now)) break;
    const double progress = look.apart.to - now;
    now = look.apart.to;
    if (progress <= 0x1p-40 * now) break;
    if (progress < kLongStride) ++looks;
  }
  return std::min(now, 1.0);
}

template <PairKind kind>
double start_distance_bound(const PairMotion<double>& m, const ClosestPoints& closest) {
  constexpr double kSharp = 1 - 0x1p-40;
  const AxisClip<kind> clip(m);
  const double along_gap = clip.distance_along(0, closest.gap);
  if (along_gap >= kSharp * std::sqrt(dot(closest.gap, closest.gap))) return along_gap;
  return std::max(along_gap, clip.distance_along(0, squared_axis<kind>(m, 0, closest).direction));
}

}  // namespace

double start_distance_bound(PairKind kind, const PairMotion<double>& m, const ClosestPoints& closest) {
  return with_kind(kind, [&](auto k) { return start_distance_bound<k()>(m, closest); });
}

Decision first_within(PairKind kind, const PairMotion<double>& m, const TimeInterval<double>& time) {
  return with_kind(kind, [&](auto k) { return Advance<k()>(m, time).run(); });
}

double apart_until(PairKind kind, const PairMotion<double>& m, double from, double until) {
  return with_kind(kind, [&](auto k) { return apart_until<k()>(m, from, until); });
}

}  // namespace tamis

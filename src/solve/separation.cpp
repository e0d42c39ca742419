#include "solve/separation.hpp"

#include <algorithm>
#include <optional>

#include "solve/apart_times.hpp"
#include "solve/closest.hpp"

namespace tamis {
namespace {

using Vec = Vec3<double>;

/// Steps shorter than this, as a fraction of the step of time, are no progress.
constexpr double kShortest = 0x1p-50;
/// Looks at one pair. Newton's method needs 3 to 8; a near miss by 1e-15 of the pair's size needs about 40.
constexpr int kMaxLooks = 160;

/// The axis of the closest points, made orthogonal to the sides on which they lie: the gap itself is off by a few u of
/// the features' size, not of its own, which would tilt the axis of a small gap. Any axis is sound.
template <PairKind kind>
Vec squared_axis(const Vec& e, const Vec& f, const ClosestPoints& closest) {
  const auto [u, v, gap] = closest;
  const auto orthogonal_to = [&gap = gap](const Vec& side) { return gap - (dot(gap, side) / dot(side, side)) * side; };
  const auto normal = [&, &gap = gap] {
    const Vec n = cross(e, f);
    return dot(n, gap) < 0 ? -n : n;
  };
  if constexpr (kind == PairKind::vertex_face) {
    const bool off_a = u + v > 0, off_b = u < 1, off_c = v < 1;
    if (u > 0 && v > 0) return u + v < 1 ? normal() : orthogonal_to(f - e);
    if (u > 0 && off_b) return orthogonal_to(e);
    return v > 0 && off_c && off_a ? orthogonal_to(f) : gap;
  } else {
    const bool inside_e = u > 0 && u<1, inside_f = v> 0 && v < 1;
    if (inside_e && inside_f) return normal();
    return inside_e ? orthogonal_to(e) : inside_f ? orthogonal_to(f) : gap;
  }
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
    constexpr double kLength = 1 + error_bounds::kLength * error_bounds::unit_roundoff<double>;
    const double farthest = std::sqrt(dot(closest.gap, closest.gap)) * kLength + error_;
    if (farthest <= m_.separation) return {true, {2, -1}, 0};
    ApartTimes apart = clip_.along(closest.gap);
    const ApartTimes other = clip_.along(squared_axis<kind>(e, f, closest));
    if (other.contains(t) && !(apart.contains(t) && apart.to >= other.to)) apart = other;
    return {false, apart.contains(t) ? apart : ApartTimes{2, -1}, wait(closest, farthest - m_.separation)};
  }

 private:
  /// Twice the time in which the closest points, were they fixed, would come closer by `excess`.
  double wait(const ClosestPoints& closest, double excess) const {
    const auto gap = [&](const Vec& e, const Vec& f, const Vec& d) {
      return kind == PairKind::vertex_face ? d - (closest.u * e + closest.v * f) : d + closest.v * f - closest.u * e;
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
    for (int looks = 0; looks < kMaxLooks && now_ <= end_; ++looks) {
      const double t = std::min(now_ + ahead_, end_);
      const Look look = looker_.at(t);
      if (look.touches) return touching(t);
      if (look.apart.contains(t))
        pass(look);
      else
        wait(look, t);
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
double apart_until(const PairMotion<double>& m, double until) {
  const Looker<kind> looker(m);
  double now = 0;
  for (int looks = 0; looks < kMaxLooks && now < until; ++looks) {
    const Look look = looker.at(now);
    if (!look.apart.contains(now)) break;
    const double progress = look.apart.to - now;
    now = look.apart.to;
    if (progress <= 0x1p-40 * now) break;
  }
  return std::min(now, 1.0);
}

}  // namespace

Decision first_within(PairKind kind, const PairMotion<double>& m, const TimeInterval<double>& time) {
  return kind == PairKind::vertex_face ? Advance<PairKind::vertex_face>(m, time).run()
                                       : Advance<PairKind::edge_edge>(m, time).run();
}

double apart_until(PairKind kind, const PairMotion<double>& m, double until) {
  return kind == PairKind::vertex_face ? apart_until<PairKind::vertex_face>(m, until)
                                       : apart_until<PairKind::edge_edge>(m, until);
}

}  // namespace tamis

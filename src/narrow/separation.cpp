#include "narrow/separation.hpp"

#include <algorithm>
#include <optional>

#include "motion/pair_kinds.hpp"
#include "narrow/advancement.hpp"
#include "numerics/assert.hpp"

namespace tamis {
namespace {

/// Looks at one pair. Newton's method needs 3 to 8; a near miss by 1e-15 of the pair's size needs about 40.
constexpr int kMaxLooks = 160;
/// Looks that advance by so much of the step do not count: a pair with room (error_bounds::kRoomToAdvance) needs no
/// others.
constexpr double kLeastProgress = error_bounds::kRoomToAdvance / 16;

/// Goes through the step from its start. Until `at_.now` everything is decided.
template <PairKind kind>
class Advance {
 public:
  Advance(const PairMotion<double>& m, const TimeInterval<double>& time)
      : looker_(m), end_(time.t_out), at_{time.t_in} {}

  Decision run() {
    for (int looks = 0; looks < kMaxLooks && at_.now <= end_;) {
      const double before = at_.now, t = std::min(before + at_.ahead, end_);
      const Sight<double> sight = looker_.sight(t);
      if (looker_.touches(sight)) {
        decision_.add_contact(at_.now, t);
        return decision_;
      }
      const Look<double> look = looker_.at(t, sight);
      if (look.until > t)
        pass(look, t);
      else
        wait(look, t);
      if (at_.now - before < kLeastProgress) ++looks;
    }
    if (at_.now <= end_) add_unsure(end_);
    return decision_;
  }

 private:
  /// A time proven apart: everything up to the end of that proof is decided, or all but a part before it.
  void pass(const Look<double>& look, double t) {
    const double since = t > at_.now ? looker_.clip().apart_since(t, look.axis) : t;
    if (t > at_.now && since >= at_.now) {
      beyond_ = {since, look.until};
      at_.ahead = 0.5 * (since - at_.now);
      if (at_.ahead > kShortestStride) return;
      add_unsure(since);
    }
    at_.pass(true, look);
    beyond_.reset();
  }

  /// A time at which doubles cannot tell: look later, until the answer is clear.
  void wait(const Look<double>& look, double t) {
    if (beyond_) {
      add_unsure(beyond_->t_in);
      continue_at(beyond_->t_out);
    } else if (t >= end_) {
      add_unsure(end_);
      continue_at(2);
    } else {
      at_.wait(true, look);
    }
  }

  void continue_at(double until) {
    at_ = {until};
    beyond_.reset();
  }

  /// Times ascend.
  void add_unsure(double until) { decision_.add_unsure(at_.now, until); }

  const Looker<kind, double> looker_;
  const double end_;
  Advancement<double> at_;
  std::optional<TimeInterval<double>> beyond_;  ///< proven apart again, after times that are not
  Decision decision_;
};

template <PairKind kind>
double apart_until(const PairMotion<double>& m, double from, double until) {
  const Looker<kind, double> looker(m);
  double now = from;
  for (int looks = 0; looks < kMaxLooks && now < until;) {
    const Sight<double> sight = looker.sight(now);
    if (looker.touches(sight)) break;
    const Look<double> look = looker.at(now, sight);
    if (!(look.until > now)) break;
    const double progress = look.until - now;
    now = look.until;
    if (progress <= 0x1p-40 * now) break;
    if (progress < kLeastProgress) ++looks;
  }
  return std::min(now, 1.0);
}

}  // namespace

Decision first_within(PairKind kind, const PairMotion<double>& m, const TimeInterval<double>& time) {
  TAMIS_ASSERT(is_part_of_step(time));
  return with_kind(kind, [&](auto k) { return Advance<k()>(m, time).run(); });
}

double apart_until(PairKind kind, const PairMotion<double>& m, double from, double until) {
  TAMIS_ASSERT(0 <= from && from <= 1);
  return with_kind(kind, [&](auto k) { return apart_until<k()>(m, from, until); });
}

}  // namespace tamis

#include "pair/narrow/decide.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "numbers/assert.hpp"
#include "pair/distance/turning_gap.hpp"
#include "pair/exact/exact.hpp"
#include "pair/motion/pair_kinds.hpp"
#include "pair/motion/polynomials.hpp"
#include "pair/narrow/contact_normal.hpp"
#include "pair/narrow/crossing_root.hpp"
#include "pair/narrow/crossing_slope.hpp"
#include "pair/narrow/decisions.hpp"

namespace tamis {
namespace {

constexpr TimeInterval<double> kWholeStep{0, 1};

/// In double-double, what doubles leave undecided by `d`. Nothing where that does not decide it.
std::optional<Decision> decide_finely(const PairInStep& pair, const Decision& d) {
  if (!is_finite(pair.motion)) return {};
  if (!is_about_distance(pair.kind, pair.separation)) return decide_crossing_finely(pair, d);
  if (pair.separation == 0 || !d.touches()) return {};
  return first_within_finely(pair, {d.lower, d.upper});
}

/// True if axes between the features prove that they stay apart during `time`. Serves pairs whose cubic has no certain
/// sign at t=0, such as edges that slide beside each other in one plane. Costs a tenth of integers. REQUIRES (not
/// checked: exact): apart outside `time`.
bool stays_apart(const PairInStep& pair, const TimeInterval<double>& time) {
  return is_finite(pair.motion) && with_kind(pair.kind, [&](auto kind) {
           return TurningGap<kind(), double>(pair.motion).stays_apart(time, kTurningGapParts);
         });
}

/// The decision in doubles. Nothing where the pair may touch at the start, which double-double does not decide either.
/// With a separation the whole step comes first. So a pair has the same bits as in lanes. Without one, beginnings come
/// first. The whole step of a pair that goes far would be cut into many parts.
std::optional<Decision> decide_by_doubles(const PairInStep& pair, const TimeInterval<double>& clip) {
  const PairMotion<double>& m = pair.motion;
  if (is_about_distance(pair.kind, m.separation)) {
    const Decision whole = decide_in_doubles(pair.kind, m, clip);
    return is_sharp_answer(whole) ? whole : decide_in_beginnings(pair).value_or(whole);
  }
  if (const auto early = decide_in_beginnings(pair)) return early;
  if (clip.t_in > 0 || !may_start_coplanar(m)) return decide_in_doubles(pair.kind, m, clip);
  return stays_apart(pair, clip) ? std::optional(Decision{}) : std::nullopt;
}

/// True if the answer of integers is not needed.
bool is_needless(const PairInStep& pair, const TimeInterval<double>& clip, double needed_until) {
  return needed_until < 1 && (clip.t_in > needed_until || stays_apart_closing_in(pair, {clip.t_in, needed_until}));
}

/// True if doubles cannot tell sharply when the pair touches, should it touch about this time. Proven where the
/// coplanarity is so flat that no crossing is sharp, nor would be in a beginning of the step until then.
bool is_flat_at(const PairInStep& pair, double time) {
  constexpr double kWidestSharp = 1e-11, kMargin = 0.125;
  const PairMotion<double>& m = pair.motion;
  if (pair.separation > 0 || !can_cross(pair.kind) || !is_finite(m)) return false;
  const double error = error_bounds::bound(error_bounds::kCoplanarityNow, m.size_d * m.size_e * m.size_f);
  return std::fabs(crossing::slope(coplanarity_polynomial(m), time)) * kWidestSharp <
         kMargin * time * time * time * error;
}

PairResult described(const PairInStep& pair, const Decision& decision) {
  if (decision.is_free()) return {};
  PairResult result;
  result.touches = true;
  result.toi_lower = decision.lower;
  result.toi_upper = decision.upper;
  set_place(result, contact_place(pair, {decision.lower, decision.upper}));
  return result;
}

/// Decides a pair that decided_by_crossings() does not.
PairResult decide_further(const PairInStep& pair, PrecisionCount& decided_by, const OfInterest& times) {
  const double latest = times.latest;
  if (const auto in_plane = decided_in_plane(pair)) {
    ++decided_by.scalar;
    return in_plane->toi_lower > latest ? PairResult{} : *in_plane;
  }
  const auto clip = clipped(pair.kind, pair.motion, kWholeStep);
  auto decision = is_proven_free(clip, latest) ? Decision{} : decide_by_doubles(pair, clip);
  if (decision && !is_sharp_answer(*decision)) decision = decide_finely(pair, *decision);
  if (!decision && is_needless(pair, clip, times.needed_until)) decision = Decision{};
  ++(decision ? decided_by.scalar : decided_by.exact);
  const double until = decision ? latest : std::min(latest, times.needed_until);
  if (!decision) decision = decide_exactly(pair.kind, pair.points, pair.separation, until);
  return decision->lower > until ? PairResult{} : described(pair, *decision);
}

}  // namespace

PairResult decide(const PairInStep& pair, PrecisionCount& decided_by, const OfInterest& times) {
  TAMIS_ASSERT(0 <= times.latest && times.latest <= 1);
  const double needed = times.needed_until;
  if (needed < times.latest && is_flat_at(pair, needed) && stays_apart_closing_in(pair, {0, needed})) {
    ++decided_by.scalar;
    return {};
  }
  const auto decided = decided_by_crossings(pair, times.latest);
  if (!decided) return decide_further(pair, decided_by, times);
  ++decided_by.scalar;
  return decided->toi_lower > times.latest ? PairResult{} : *decided;
}

PairResult decide_recontact(const PairInStep& pair, PrecisionCount& decided_by) {
  const PairMotion<double>& m = pair.motion;
  const auto again = is_finite(m) && m.separation > 0 ? first_recontact_within(pair.kind, m) : std::nullopt;
  const bool is_decided = again && is_sharp_answer(*again);
  ++(is_decided ? decided_by.scalar : decided_by.exact);
  return described(pair, is_decided ? *again : decide_recontact_exactly(pair.kind, pair.points, pair.separation));
}

}  // namespace tamis

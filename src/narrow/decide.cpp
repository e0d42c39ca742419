#include "narrow/decide.hpp"

#include <algorithm>
#include <optional>

#include "distance/turning_gap.hpp"
#include "exact/exact.hpp"
#include "filters/slab_clip.hpp"
#include "motion/pair_kinds.hpp"
#include "narrow/contact_normal.hpp"
#include "narrow/decide_in_doubles.hpp"
#include "narrow/decided_by_crossing.hpp"
#include "narrow/fine_crossing.hpp"
#include "narrow/fine_separation.hpp"
#include "narrow/pair_beginnings.hpp"
#include "narrow/recontact.hpp"
#include "numerics/assert.hpp"

namespace tamis {
namespace {

constexpr TimeInterval<double> kWholeStep{0, 1};

/// What doubles leave undecided, again: other units of time and length, or of precision. Nothing where these do not
/// decide it.
std::optional<Decision> decide_again(PairKind kind, const PairPoints& points, double separation,
                                     const PairMotion<double>& m, const Decision& d) {
  if (!is_finite(m)) return {};
  if (!is_about_distance(kind, separation)) return decide_crossing_finely(kind, points, m, d);
  if (separation == 0 || !d.touches()) return {};
  return first_within_finely(kind, points, separation, m, {d.lower, d.upper});
}

/// What is decided of a pair, and by what arithmetic.
struct Outcome {
  Decision decision;
  std::uint64_t PrecisionCount::*arithmetic;
};

bool is_proven_free(const TimeInterval<double>& clip, const ContactRule& rule) {
  return clip.t_in > clip.t_out || clip.t_in > rule.latest;
}

/// What one crossing decides in what the clip on the coordinates leaves, or two in what that on all axes does; nothing
/// where that takes more.
template <PairKind kind, SlabClip::Axes axes>
std::optional<PairResult> decided_after_clip(const PairMotion<double>& m, const ContactRule& rule) {
  const auto clip = SlabClip::clip<kind, axes>(m, kWholeStep);
  if (is_proven_free(clip, rule)) return PairResult{};
  if (clip.t_in == 0 && may_start_coplanar(m)) return {};
  const auto part = widened(clip);
  const auto s = decided_by_crossing(
      axes == SlabClip::Axes::coordinates ? find_crossing<kind>(m, part) : find_crossing_in_halves<kind>(m, part),
      clip);
  if (s.is_free) return PairResult{};
  if (!s.touches) return {};
  return PairResult{true, Certainty::certified, s.lower, s.upper, s.u, s.v, {s.normal.x, s.normal.y, s.normal.z}};
}

template <PairKind kind>
std::optional<PairResult> decided_by_crossings(const PairMotion<double>& m, const ContactRule& rule) {
  const auto by_one = decided_after_clip<kind, SlabClip::Axes::coordinates>(m, rule);
  return by_one ? by_one : decided_after_clip<kind, SlabClip::Axes::all>(m, rule);
}

std::optional<PairResult> decided_by_crossings(PairKind kind, const PairMotion<double>& m, const ContactRule& rule) {
  if (is_about_distance(kind, rule.min_separation) || !is_finite(m)) return {};
  return kind == PairKind::vertex_face ? decided_by_crossings<PairKind::vertex_face>(m, rule)
                                       : decided_by_crossings<PairKind::edge_edge>(m, rule);
}

/// Of a pair whose cubic has no certain sign at t=0, as of edges that slide beside each other in one plane: axes
/// between the two may still tell that they stay apart, at a tenth of the cost of integers. REQUIRES (not checked:
/// exact): apart outside `time`.
bool stays_apart(PairKind kind, const PairMotion<double>& m, const TimeInterval<double>& time) {
  return is_finite(m) &&
         with_kind(kind, [&](auto k) { return TurningGap<k(), double>(m).stays_apart(time, kTurningGapParts); });
}

/// What doubles say; nothing where the pair may touch at the start, which double-double does not decide either. With a
/// separation they are asked about the whole step first, so that a pair has the bits that it has in lanes; without one
/// they would cut what goes far into many parts there.
std::optional<Decision> decide_by_doubles(PairKind kind, const PairPoints& points, const PairMotion<double>& m,
                                          const TimeInterval<double>& clip, double separation) {
  if (is_about_distance(kind, m.separation)) {
    const Decision whole = decide_in_doubles(kind, m, clip);
    return is_sharp_answer(whole) ? whole : decide_in_beginnings(kind, points, separation, m).value_or(whole);
  }
  if (const auto early = decide_in_beginnings(kind, points, separation, m)) return early;
  if (clip.t_in > 0 || !may_start_coplanar(m)) return decide_in_doubles(kind, m, clip);
  return stays_apart(kind, m, clip) ? std::optional(Decision{}) : std::nullopt;
}

Outcome decide_pair(PairKind kind, const PairPoints& points, const PairMotion<double>& m,
                    const TimeInterval<double>& clip, const ContactRule& rule) {
  if (is_proven_free(clip, rule)) return {{}, &PrecisionCount::scalar};
  auto decision = decide_by_doubles(kind, points, m, clip, rule.min_separation);
  if (decision && !is_sharp_answer(*decision)) decision = decide_again(kind, points, rule.min_separation, m, *decision);
  return decision ? Outcome{*decision, &PrecisionCount::scalar}
                  : Outcome{decide_exactly(kind, points, rule.min_separation), &PrecisionCount::exact};
}

PairResult described(PairKind kind, const PairPoints& points, const PairMotion<double>& m, const Decision& decision) {
  if (decision.is_free()) return {};
  PairResult result;
  result.touches = true;
  result.toi_lower = decision.lower;
  result.toi_upper = decision.upper;
  describe_contact(kind, points, m, result);
  return result;
}

/// Of a pair that crossings do not decide.
PairResult decide_motion(PairKind kind, const PairPoints& points, const PairMotion<double>& m, const ContactRule& rule,
                         PrecisionCount& decided_by) {
  const auto [decision, arithmetic] = decide_pair(kind, points, m, clipped(kind, m, kWholeStep), rule);
  ++(decided_by.*arithmetic);
  return decision.lower > rule.latest ? PairResult{} : described(kind, points, m, decision);
}

}  // namespace

PairResult decide(PairKind kind, const PairPoints& points, const ContactRule& rule, PrecisionCount& decided_by) {
  TAMIS_ASSERT(0 <= rule.latest && rule.latest <= 1);
  const auto m = make_motion(kind, points, rule.min_separation);
  const auto decided = decided_by_crossings(kind, m, rule);
  if (!decided) return decide_motion(kind, points, m, rule, decided_by);
  ++decided_by.scalar;
  return decided->toi_lower > rule.latest ? PairResult{} : *decided;
}

PairResult decide_recontact(PairKind kind, const PairPoints& points, double separation, PrecisionCount& decided_by) {
  const auto m = make_motion(kind, points, separation);
  const auto again = is_finite(m) && m.separation > 0 ? first_recontact_within(kind, m) : std::nullopt;
  const auto [decision, arithmetic] =
      again && is_sharp_answer(*again)
          ? Outcome{*again, &PrecisionCount::scalar}
          : Outcome{decide_recontact_exactly(kind, points, separation), &PrecisionCount::exact};
  ++(decided_by.*arithmetic);
  return described(kind, points, m, decision);
}

PairResult decide_undecided(PairKind kind, const PairPoints& points, const ContactRule& rule,
                            PrecisionCount& decided_by) {
  const auto m = make_motion(kind, points, rule.min_separation);
  TAMIS_ASSERT(!decided_by_crossings(kind, m, rule));
  return decide_motion(kind, points, m, rule, decided_by);
}

}  // namespace tamis

#include "narrow/decide.hpp"

#include <algorithm>
#include <optional>

#include "distance/turning_gap.hpp"
#include "exact/exact.hpp"
#include "filters/slab_clip.hpp"
#include "motion/pair_kinds.hpp"
#include "narrow/contact_normal.hpp"
#include "narrow/decided_by_crossing.hpp"
#include "narrow/far_flight.hpp"
#include "narrow/finely.hpp"
#include "narrow/leaving.hpp"
#include "narrow/separation.hpp"
#include "narrow/subdivide.hpp"
#include "numerics/assert.hpp"

namespace tamis {
namespace {

constexpr TimeInterval<double> kWholeStep{0, 1};

/// The times that the slab clip leaves.
TimeInterval<double> time_in_question(PairKind kind, const PairMotion<double>& m) {
  if (!is_finite(m)) return kWholeStep;
  return with_kind(kind, [&](auto k) { return SlabClip::clip<k()>(m, kWholeStep); });
}

/// The decision without what the clip proves free.
Decision within(const TimeInterval<double>& clip, Decision d) {
  if (d.is_free()) return d;
  d.lower = std::max(d.lower, clip.t_in);
  d.upper = std::min(d.upper, clip.t_out);
  return d.verdict == Verdict::unsure && d.lower > d.upper ? Decision{} : d;
}

Decision decide_in_doubles(PairKind kind, const PairMotion<double>& m, const TimeInterval<double>& clip) {
  if (!is_finite(m)) return {Verdict::unsure, 0, 1};
  return is_about_distance(kind, m.separation) ? first_within(kind, m, clip)
                                               : within(clip, subdivide(kind, m, widened(clip)));
}

/// What doubles leave undecided, again: other units of time and length, or of precision. Nothing where these do not
/// decide it.
std::optional<Decision> decide_again(PairKind kind, const PairPoints& points, double separation,
                                     const PairMotion<double>& m, const Decision& d) {
  if (!is_finite(m)) return {};
  const TimeInterval<double> bracket{d.lower, d.upper};
  if (separation == 0 && !can_cross(kind)) return {};
  if (d.verdict == Verdict::unsure && separation == 0) return decide_crossing_finely(kind, points, m, bracket);
  if (d.verdict == Verdict::unsure)
    return flies_past(kind, points, separation, m) ? std::optional(Decision{}) : std::nullopt;
  return separation > 0 ? first_within_finely(kind, points, separation, m, bracket)
                        : first_crossing_finely(kind, points, m, bracket);
}

/// What is decided of a pair, and by what arithmetic.
struct Outcome {
  Decision decision;
  std::uint64_t PrecisionCount::*arithmetic;
};

bool is_sharp_answer(const Decision& d) { return d.is_free() || (d.touches() && is_sharp(d.lower, d.upper)); }

bool is_proven_free(const TimeInterval<double>& clip, const ContactRule& rule) {
  return clip.t_in > clip.t_out || clip.t_in > rule.latest;
}

/// What a crossing that `find` finds in widened(clip) decides; nothing where that takes more.
template <class Find>
std::optional<PairResult> decided_within(const PairMotion<double>& m, const TimeInterval<double>& clip,
                                         const ContactRule& rule, const Find& find) {
  if (is_proven_free(clip, rule)) return PairResult{};
  if (clip.t_in == 0 && may_start_coplanar(m)) return {};
  const auto s = decided_by_crossing(find(m, widened(clip)), clip);
  if (s.is_free) return PairResult{};
  if (!s.touches) return {};
  return PairResult{true, Certainty::certified, s.lower, s.upper, s.u, s.v, {s.normal.x, s.normal.y, s.normal.z}};
}

template <PairKind kind>
std::optional<PairResult> decided_by_crossings(const PairMotion<double>& m, const ContactRule& rule) {
  const auto one = [](const auto&... in) { return find_crossing<kind>(in...); };
  const auto in_halves = [](const auto&... in) { return find_crossing_in_halves<kind>(in...); };
  if (const auto result =
          decided_within(m, SlabClip::clip<kind, SlabClip::Axes::coordinates>(m, kWholeStep), rule, one))
    return result;
  return decided_within(m, SlabClip::clip<kind>(m, kWholeStep), rule, in_halves);
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

Outcome decide_pair(PairKind kind, const PairPoints& points, const PairMotion<double>& m,
                    const TimeInterval<double>& clip, const ContactRule& rule) {
  if (is_proven_free(clip, rule)) return {{}, &PrecisionCount::scalar};
  if (clip.t_in == 0 && !is_about_distance(kind, m.separation) && may_start_coplanar(m))
    return stays_apart(kind, m, clip)
               ? Outcome{{}, &PrecisionCount::scalar}
               : Outcome{decide_exactly(kind, points, rule.min_separation), &PrecisionCount::exact};
  const Decision d = decide_in_doubles(kind, m, clip);
  if (is_sharp_answer(d)) return {d, &PrecisionCount::scalar};
  if (const auto again = decide_again(kind, points, rule.min_separation, m, d))
    return {*again, &PrecisionCount::scalar};
  return {decide_exactly(kind, points, rule.min_separation), &PrecisionCount::exact};
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
  const auto [decision, arithmetic] = decide_pair(kind, points, m, time_in_question(kind, m), rule);
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

PairResult decide_once_apart(PairKind kind, const PairPoints& points, double separation, PrecisionCount& decided_by) {
  const auto m = make_motion(kind, points, separation);
  const auto again = is_finite(m) && m.separation > 0 ? within_once_apart(kind, m) : std::nullopt;
  const auto [decision, arithmetic] =
      again && is_sharp_answer(*again)
          ? Outcome{*again, &PrecisionCount::scalar}
          : Outcome{decide_once_apart_exactly(kind, points, separation), &PrecisionCount::exact};
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

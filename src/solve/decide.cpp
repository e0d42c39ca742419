#include "solve/decide.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "filters/filters.hpp"
#include "motion/pair_kinds.hpp"
#include "solve/exact.hpp"
#include "solve/separation.hpp"
#include "solve/settled.hpp"
#include "solve/start_distance.hpp"
#include "solve/subdivide.hpp"
#include "solve/weights.hpp"

namespace tamis {
namespace {

/// Otherwise what counts is when the four points are coplanar.
bool is_about_distance(PairKind kind, double separation) { return separation > 0 || !can_cross(kind); }

constexpr TimeInterval<double> kWholeStep{0, 1};

/// The times that the slab clip leaves.
TimeInterval<double> time_in_question(PairKind kind, const PairMotion<double>& m) {
  if (!is_finite(m)) return kWholeStep;
  return with_kind(kind, [&](auto k) { return SlabClip::clip<k()>(m, kWholeStep); });
}

/// The decision without what the clip proves free.
Decision within(const TimeInterval<double>& clip, Decision d) {
  if (d.verdict == Verdict::is_free) return d;
  d.lower = std::max(d.lower, clip.t_in);
  d.upper = std::min(d.upper, clip.t_out);
  return d.verdict == Verdict::unsure && d.lower > d.upper ? Decision{} : d;
}

Decision decide_in_doubles(PairKind kind, const PairMotion<double>& m, const TimeInterval<double>& clip) {
  if (!is_finite(m)) return {Verdict::unsure, 0, 1};
  return is_about_distance(kind, m.separation) ? first_within(kind, m, clip)
                                               : within(clip, subdivide(kind, m, widened(clip)));
}

/// The start of the step is decided exactly: a pair that is apart there, by whatever little, has a time before it
/// touches; so a line search never stops for nothing.
Decision with_exact_start(PairKind kind, const PairPoints& points, double separation, const Decision& decision) {
  if (decision.verdict == Verdict::is_free || decision.lower > 0 || decision.upper == 0) return decision;
  const double apart = apart_from_start(kind, points, separation);
  if (apart == 0) return {Verdict::touches, 0, 0};
  if (std::isinf(apart)) return {};
  return {decision.verdict, std::min(apart, decision.upper), decision.upper};
}

/// What is decided of a pair, and by what arithmetic.
struct Outcome {
  Decision decision;
  std::uint64_t PrecisionCount::*arithmetic;
};

Outcome decide_in_integers(PairKind kind, const PairPoints& points, double separation) {
  const auto exact = decide_exactly(kind, points, separation);
  const Verdict verdict = exact.touches ? Verdict::touches : Verdict::is_free;
  return {{verdict, exact.toi_lower, exact.toi_upper}, &PrecisionCount::exact};
}

/// What some method proves, or a detector remembers, must not stay unsure elsewhere: so all that any of them tries is
/// tried here, and a pair that stays apart by kRoomToAdvance of its size is always free.
Decision decide_as_any_method(PairKind kind, const PairMotion<double>& m, const Decision& open) {
  if (any_filter_proves_free(kind, m)) return {};
  if (first_within(kind, m, {open.lower, open.upper}).verdict == Verdict::is_free) return {};
  return subdivide(kind, m, {open.lower, open.upper}, InPlane::thoroughly);
}

/// REQUIRES: `separation` in the unit of the points; that of `m` has been scaled.
Outcome decide_conservatively(PairKind kind, const PairPoints& points, const PairMotion<double>& m, double separation,
                              Decision d) {
  if (is_about_distance(kind, separation))
    d = with_exact_start(kind, points, separation, d);
  else if (d.verdict == Verdict::unsure && is_finite(m))
    d = decide_as_any_method(kind, m, d);
  return {d, d.verdict == Verdict::unsure ? &PrecisionCount::unresolved : &PrecisionCount::scalar};
}

bool is_proven_free(const TimeInterval<double>& clip, const PairOptions& options) {
  return clip.t_in > clip.t_out || clip.t_in > options.latest;
}

/// What a crossing that `find` finds in widened(clip) settles; nothing where that takes more.
template <class Find>
std::optional<PairResult> settled_within(const PairMotion<double>& m, const TimeInterval<double>& clip,
                                         const PairOptions& options, const Find& find) {
  const bool is_exact = options.guarantee == Guarantee::exact;
  if (is_proven_free(clip, options)) return PairResult{};
  if (is_exact && clip.t_in == 0 && may_start_coplanar(m)) return {};
  const auto s = settled(find(m, widened(clip)), clip, is_exact);
  if (s.is_free) return PairResult{};
  if (!s.touches) return {};
  return PairResult{true, Certainty::certified, s.lower, s.upper, s.u, s.v, {s.normal.x, s.normal.y, s.normal.z}};
}

template <PairKind kind>
std::optional<PairResult> settled_by_crossings(const PairMotion<double>& m, const PairOptions& options) {
  const auto one = [](const auto&... in) { return find_crossing<kind>(in...); };
  const auto in_halves = [](const auto&... in) { return find_crossing_in_halves<kind>(in...); };
  if (const auto result =
          settled_within(m, SlabClip::clip<kind, SlabClip::Axes::coordinates>(m, kWholeStep), options, one))
    return result;
  return settled_within(m, SlabClip::clip<kind>(m, kWholeStep), options, in_halves);
}

std::optional<PairResult> settled_by_crossings(PairKind kind, const PairMotion<double>& m, const PairOptions& options) {
  if (is_about_distance(kind, m.separation) || !is_finite(m)) return {};
  return kind == PairKind::vertex_face ? settled_by_crossings<PairKind::vertex_face>(m, options)
                                       : settled_by_crossings<PairKind::edge_edge>(m, options);
}

Outcome decide_pair(PairKind kind, const PairPoints& points, const PairMotion<double>& m,
                    const TimeInterval<double>& clip, const PairOptions& options) {
  if (is_proven_free(clip, options)) return {{}, &PrecisionCount::scalar};
  const bool is_exact = options.guarantee == Guarantee::exact;
  if (is_exact && clip.t_in == 0 && !is_about_distance(kind, m.separation) && may_start_coplanar(m))
    return decide_in_integers(kind, points, options.min_separation);
  const Decision d = decide_in_doubles(kind, m, clip);
  if (d.verdict == Verdict::is_free) return {d, &PrecisionCount::scalar};
  if (!is_exact) return decide_conservatively(kind, points, m, options.min_separation, d);
  if (d.verdict == Verdict::touches && is_sharp(d.lower, d.upper)) return {d, &PrecisionCount::scalar};
  return decide_in_integers(kind, points, options.min_separation);
}

PairResult with_weights(PairKind kind, const PairMotion<double>& m, const Decision& decision) {
  if (decision.verdict == Verdict::is_free) return {};
  PairResult result;
  result.touches = true;
  result.certainty = decision.verdict == Verdict::touches ? Certainty::certified : Certainty::unresolved;
  result.toi_lower = decision.lower;
  result.toi_upper = decision.upper;
  add_weights(kind, m, 0.5 * (result.toi_lower + result.toi_upper), result);
  return result;
}

/// REQUIRES: crossings do not settle `m`.
PairResult decide_motion(PairKind kind, const PairPoints& points, const PairMotion<double>& m,
                         const PairOptions& options, PrecisionCount& decided_by) {
  const auto [decision, arithmetic] = decide_pair(kind, points, m, time_in_question(kind, m), options);
  ++(decided_by.*arithmetic);
  return decision.lower > options.latest ? PairResult{} : with_weights(kind, m, decision);
}

}  // namespace

PairResult decide(PairKind kind, const PairPoints& points, const PairOptions& options, PrecisionCount& decided_by) {
  const auto m = make_motion(kind, points, options.min_separation);
  const auto settled = settled_by_crossings(kind, m, options);
  if (!settled) return decide_motion(kind, points, m, options, decided_by);
  ++decided_by.scalar;
  return settled->toi_lower > options.latest ? PairResult{} : *settled;
}

PairResult decide_unsettled(PairKind kind, const PairPoints& points, const PairOptions& options,
                            PrecisionCount& decided_by) {
  return decide_motion(kind, points, make_motion(kind, points, options.min_separation), options, decided_by);
}

}  // namespace tamis

#include "solve/decide.hpp"

#include <algorithm>
#include <cmath>

#include "filters/filters.hpp"
#include "motion/pair_kinds.hpp"
#include "solve/exact.hpp"
#include "solve/extended.hpp"
#include "solve/separation.hpp"
#include "solve/start_distance.hpp"
#include "solve/subdivide.hpp"
#include "solve/weights.hpp"

namespace tamis {
namespace {

/// Otherwise what counts is when the four points are coplanar.
bool is_about_distance(PairKind kind, double separation) { return separation > 0 || !can_cross(kind); }

bool is_finite(const PairMotion<double>& m) { return std::isfinite(m.size_e + m.size_f + m.size_d); }

/// A face that meets the axes squarely is clipped to the very instant of contact, where no sign is certain any more.
TimeInterval<double> widened(const TimeInterval<double>& time) {
  constexpr double kRoom = 1.0 / 1024;
  return {std::max(time.t_in - kRoom, 0.0), std::min(time.t_out + kRoom, 1.0)};
}

TimeInterval<double> slab_clip(PairKind kind, const PairMotion<double>& m) {
  return with_kind(kind, [&](auto k) { return SlabClip::clip<k()>(m, TimeInterval<double>{0, 1}); });
}

/// The decision without what the clip proves free.
Decision within(const TimeInterval<double>& clip, Decision d) {
  if (d.verdict == Verdict::is_free) return d;
  d.lower = std::max(d.lower, clip.t_in);
  d.upper = std::min(d.upper, clip.t_out);
  return d.verdict == Verdict::unsure && d.lower > d.upper ? Decision{} : d;
}

Decision decide_in_doubles(PairKind kind, const PairMotion<double>& m) {
  if (!is_finite(m)) return {Verdict::unsure, 0, 1};
  const auto clip = slab_clip(kind, m);
  if (clip.t_in > clip.t_out) return {};
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

/// What some method proves, or a detector remembers, must not stay unsure elsewhere: so all that any of them tries is
/// tried here, and a pair that stays apart by kRoomToAdvance of its size is always free.
Decision decide_as_any_method(PairKind kind, const PairMotion<double>& m, const Decision& open) {
  if (any_filter_proves_free(kind, m)) return {};
  if (first_within(kind, m, {open.lower, open.upper}).verdict == Verdict::is_free) return {};
  return subdivide(kind, m, {open.lower, open.upper}, InPlane::thoroughly);
}

/// Where doubles end.
Outcome decide_further(PairKind kind, const PairPoints& points, const PairMotion<double>& m, const Decision& open) {
  const Decision extended = decide_in_extended(kind, points, {open.lower, open.upper});
  if (extended.verdict != Verdict::unsure) return {extended, &PrecisionCount::extended};
  if (open.verdict == Verdict::touches) return {open, &PrecisionCount::scalar};
  const Decision last = decide_as_any_method(kind, m, extended);
  if (last.verdict != Verdict::unsure) return {last, &PrecisionCount::scalar};
  return {extended, &PrecisionCount::unresolved};
}

Outcome decide_by_rounding(PairKind kind, const PairPoints& points, const PairMotion<double>& m) {
  const Decision d = decide_in_doubles(kind, m);
  if (d.verdict == Verdict::is_free) return {d, &PrecisionCount::scalar};
  if (!is_finite(m)) return {d, &PrecisionCount::unresolved};
  if (!d.is_one_crossing) return decide_further(kind, points, m, d);
  if (d.upper - d.lower <= kWideBracket) return {d, &PrecisionCount::scalar};
  const auto bracket = sharpened(kind, points, {d.lower, d.upper});
  return {{d.verdict, bracket.t_in, bracket.t_out}, &PrecisionCount::scalar};
}

Outcome decide_by_distance(PairKind kind, const PairPoints& points, const PairMotion<double>& m, double separation) {
  const Decision d = with_exact_start(kind, points, separation, decide_in_doubles(kind, m));
  return {d, d.verdict == Verdict::unsure ? &PrecisionCount::unresolved : &PrecisionCount::scalar};
}

Outcome decide_pair(PairKind kind, const PairPoints& points, const PairMotion<double>& m, const PairOptions& options) {
  const double separation = options.min_separation;
  const Outcome outcome = is_about_distance(kind, separation) ? decide_by_distance(kind, points, m, separation)
                                                              : decide_by_rounding(kind, points, m);
  const bool is_exact = options.guarantee == Guarantee::exact && separation == 0;
  if (outcome.decision.verdict != Verdict::unsure || !is_exact) return outcome;
  const auto exact = decide_exactly(kind, points);
  const Verdict verdict = exact.touches ? Verdict::touches : Verdict::is_free;
  return {{verdict, exact.toi_lower, exact.toi_upper}, &PrecisionCount::exact};
}

}  // namespace

PairResult decide(PairKind kind, const PairPoints& points, const PairOptions& options, PrecisionCount& decided_by) {
  const auto m = make_motion(kind, points, options.min_separation);
  const auto [decision, arithmetic] = decide_pair(kind, points, m, options);
  ++(decided_by.*arithmetic);
  if (decision.verdict == Verdict::is_free) return {};
  PairResult result;
  result.touches = true;
  result.certainty = decision.verdict == Verdict::touches ? Certainty::certified : Certainty::unresolved;
  result.toi_lower = decision.lower;
  result.toi_upper = decision.upper;
  add_weights(kind, m, 0.5 * (result.toi_lower + result.toi_upper), result);
  return result;
}

}  // namespace tamis

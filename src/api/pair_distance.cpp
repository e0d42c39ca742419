#include "tamis/pair_distance.hpp"

#include <optional>

#include "api/pair_faults.hpp"
#include "api/validate.hpp"
#include "numbers/floating_point_state.hpp"
#include "pair/motion/time_clip.hpp"
#include "pair/narrow/decide.hpp"
#include "pair/narrow/kept_distance.hpp"
#include "pair/narrow/near_pair.hpp"
#include "search/query/step_limit.hpp"
#include "tamis/error.hpp"

namespace tamis {
namespace {

void validate(const FeaturePair& pair, const Step& step) {
  validate_layout(step);
  if (const std::string fault = fault_of(pair, step); !fault.empty()) throw InvalidStep(fault);
}

/// When a pair ends a step: provably not before t_in, and provably by t_out unless that is 1. None if the pair does not
/// end it before the latest time of interest.
using End = std::optional<TimeInterval<double>>;

End end_by_contact(const FeaturePair& pair, const PairPoints& points, const PairOptions& options) {
  PrecisionCount decided_by;
  const PairResult r = decide({pair.kind, points, options.min_separation}, decided_by, {options.latest});
  if (!r.touches) return {};
  return TimeInterval<double>{r.toi_lower, r.toi_upper};
}

End end_by_distance(const FeaturePair& pair, const PairPoints& points, double keep, const PairOptions& options) {
  PrecisionCount decided_by;
  const DistanceRule kept{keep, options.min_separation};
  const double until = keeps_distance_until(pair.kind, points, kept, options.latest, decided_by);
  if (until >= options.latest) return {};
  return TimeInterval<double>{until, fraction_is_left_at(pair.kind, points, kept, until)};
}

}  // namespace

NearPair distance_of(const FeaturePair& pair, const Positions& positions) {
  const ComputingState state;
  const Step rest{positions, positions};
  validate(pair, rest);
  const PairVertices vertices = vertices_in_use(pair.kind, pair.vertices);
  return near_pair(pair.kind, vertices, points_of(rest, vertices));
}

SafeStep safe_step(const FeaturePair& pair, const Step& step, double keep, const PairOptions& options) {
  const ComputingState state;
  validate(pair, step);
  tamis::validate(options);
  validate_kept(keep);
  const PairVertices vertices = vertices_in_use(pair.kind, pair.vertices);
  const PairPoints points = points_of(step, vertices);
  const End end = keep > 0 ? end_by_distance(pair, points, keep, options) : end_by_contact(pair, points, options);
  if (!end) return {options.latest, 1, {}};
  return {end->t_in, end->t_out, near_pair(pair.kind, vertices, points)};
}

}  // namespace tamis

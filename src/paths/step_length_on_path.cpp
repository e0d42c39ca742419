// Step lengths on curves. The distance that a pair must keep counts as its separation: the time at which it is reached
// is found as with any other separation.
#include "narrow/near_pair.hpp"
#include "paths/decide_path.hpp"
#include "paths/path_reader.hpp"
#include "paths/path_search.hpp"

namespace tamis {
namespace {

/// The near pair of the rounded positions at t=0; its distance is in the path's unit.
NearPair near_pair_at_start(const Path& path, PairKind kind, const PairVertices& vertices) {
  const PairReader reader(path, vertices, 0);
  const auto moment = reader.at<double>(0);
  NearPair pair = near_pair(kind, vertices, points_between(moment, moment));
  pair.distance /= reader.scale();
  return pair;
}

}  // namespace

SafeStep PathSearch::find_step_length() {
  const EarliestContact first = first_of(find());
  if (!first.contact) return {};
  const auto& [kind, certainty, vertices, toi_lower, toi_upper, u, v, normal] = *first.contact;
  SafeStep step{toi_lower, first.toi_upper, near_pair_at_start(asked_.path, kind, vertices)};
  if (asked_.keep > 0) {
    const DistanceRule rule{asked_.keep, query_.separations.between(kind, vertices)};
    const KeptSeparation kept = kept_separation(asked_.path, kind, vertices, rule);
    const PathQuestion question{asked_.path, kind, vertices, kept.low, asked_.tolerance, query_.is_cancelled};
    const Decision decision = decide_on_path(question, {toi_lower, 1});
    step.upper = decision.touches() ? decision.upper : 1;
  }
  return step;
}

}  // namespace tamis

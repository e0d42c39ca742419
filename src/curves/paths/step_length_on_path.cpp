// Step lengths on curves. The distance that a pair must keep counts as its separation. The time when it is reached is
// found as with any other separation.
#include "curves/paths/carried_pair.hpp"
#include "curves/paths/decide_path.hpp"
#include "curves/paths/path_reader.hpp"
#include "curves/paths/path_search.hpp"
#include "pair/narrow/near_pair.hpp"

namespace tamis {
namespace {

/// The near pair of the rounded positions at t=0. Its distance is in the path's unit.
NearPair near_pair_at_start(const CarriedPair& carried, PairKind kind, const PairVertices& vertices) {
  const PairReader reader(carried.path(), carried.vertices(), 0);
  const auto moment = reader.at<double>(0);
  NearPair pair = near_pair(kind, vertices, points_between(moment, moment));
  pair.distance /= reader.scale();
  pair.direction = carried.to_world(0, pair.direction);
  return pair;
}

}  // namespace

SafeStep PathSearch::find_step_length() {
  const EarliestContact first = first_of(find());
  if (!first.contact) return {};
  const auto& [kind, certainty, vertices, toi_lower, toi_upper, u, v, normal] = *first.contact;
  const CarriedPair carried(asked_.path, kind, vertices);
  SafeStep step{toi_lower, first.toi_upper, near_pair_at_start(carried, kind, vertices)};
  if (asked_.keep > 0) {
    const DistanceRule rule{asked_.keep, query_.separations.between(kind, vertices)};
    const KeptSeparation kept = kept_separation(carried.path(), kind, carried.vertices(), rule);
    const PathQuestion question{carried.path(),     kind, carried.vertices(), kept.low, asked_.tolerance,
                                query_.is_cancelled};
    const Decision decision = decide_on_path(question, {toi_lower, 1});
    step.toi_upper = decision.touches() ? decision.upper : 1;
  }
  return step;
}

}  // namespace tamis

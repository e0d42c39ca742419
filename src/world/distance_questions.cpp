// pairs_within, intersections, has_intersection and safe_step of a world.
#include <algorithm>
#include <tuple>

#include "detect/detector_access.hpp"
#include "detect/validate.hpp"
#include "world/named_pairs.hpp"
#include "world/world_state.hpp"

namespace tamis {

std::vector<BodyNearPair> World::State::pairs_within(double distance) {
  validate_distance(distance, "the distance");
  std::vector<BodyNearPair> all;
  for_each_by_itself([&](BodyId id, Body& body, Detector& itself) {
    for (const NearPair& pair : itself.pairs_within(body.deforming()->start, distance))
      all.push_back({pair, twice(id)});
    return true;
  });
  gather_at_rest(distance);
  if (at_rest_.is_asked()) {
    Gathered& gathered = *at_rest_.gathered;
    for (const NearPair& pair : gathered.detector().pairs_within(gathered.start(bodies), distance)) {
      BodyNearPair one{pair, {}};
      one.bodies = gathered.name(pair.kind, one.vertices);
      all.push_back(one);
    }
    add_statistics(gathered.detector().statistics());
  }
  std::ranges::sort(all, is_before<BodyNearPair>);
  return all;
}

std::vector<BodyIntersection> World::State::intersections() {
  std::vector<BodyIntersection> all;
  for_each_by_itself([&](BodyId id, Body& body, Detector& itself) {
    for (const Intersection& one : itself.intersections(body.deforming()->start)) all.push_back({one, twice(id)});
    return true;
  });
  gather_at_rest(0);
  if (at_rest_.is_asked()) {
    Gathered& gathered = *at_rest_.gathered;
    for (const Intersection& one :
         DetectorAccess::intersections_by_pair(gathered.detector(), gathered.start(bodies), Question::all_contacts))
      all.push_back(gathered.named(one));
    add_statistics(gathered.detector().statistics());
  }
  std::ranges::sort(all, [](const auto& a, const auto& b) {
    return std::tie(a.bodies[0], a.edge, a.bodies[1], a.face) < std::tie(b.bodies[0], b.edge, b.bodies[1], b.face);
  });
  return all;
}

bool World::State::has_intersection() {
  gather_at_rest(0);
  bool has_one = false;
  if (at_rest_.is_asked()) {
    Gathered& gathered = *at_rest_.gathered;
    has_one =
        !DetectorAccess::intersections_by_pair(gathered.detector(), gathered.start(bodies), Question::is_free).empty();
    add_statistics(gathered.detector().statistics());
  }
  if (!has_one)
    for_each_by_itself([&](BodyId, Body& body, Detector& itself) {
      has_one = itself.has_intersection(body.deforming()->start);
      return !has_one;
    });
  return has_one;
}

/// A pair that starts at the distance d, beyond the separation, and keeps no more than f d has come f w / (1 - f) near,
/// w being how far both bodies go.
BodyStep World::State::safe_step(double fraction, const QueryOptions& asked) {
  validate_kept(fraction);
  validate_of_path(asked);
  gather_moving({separation(asked), fraction / (1 - fraction)});
  BodyStep first;
  const auto add = [&](const SafeStep& step, const auto& name) {
    first.upper = std::min(first.upper, step.upper);
    if (!step.pair || step.lower > first.lower) return;
    BodyStep::Pair named{*step.pair, {}};
    named.bodies = name(named);
    if (first.pair && step.lower == first.lower && !is_before(named, *first.pair)) return;
    first.lower = step.lower;
    first.pair = named;
  };
  for_each_by_itself([&](BodyId id, Body& body, Detector& itself) {
    add(itself.safe_step(body.step(), fraction, of_steps(asked)), [&](auto&) { return twice(id); });
    return true;
  });
  const auto add_gathered = [&](const Gathered& gathered, const SafeStep& step) {
    add(step, [&](auto& pair) { return gathered.name(pair.kind, pair.vertices); });
    return true;
  };
  for_each_gathered(
      asked,
      [&](Gathered& gathered, const Step& step, const QueryOptions& how) {
        return add_gathered(gathered, gathered.detector().safe_step(step, fraction, how));
      },
      [&](Gathered& gathered, const CutPath& path, const QueryOptions& how) {
        return add_gathered(gathered, DetectorAccess::safe_step(gathered.detector(), path, fraction, how));
      });
  if (asked.at_start == AtStart::fail && first.pair && first.lower == 0)
    refuse_touching_start(first.pair->kind, first.pair->vertices, first.pair->bodies);
  return first;
}

}  // namespace tamis

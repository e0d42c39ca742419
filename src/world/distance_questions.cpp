// pairs_within, intersections, has_intersection and safe_step of a world.
#include <algorithm>

#include "detect/validate.hpp"
#include "world/ordered_parts.hpp"
#include "world/world_state.hpp"

namespace tamis {

std::vector<BodyNearPair> World::State::pairs_within(double distance) {
  validate_distance(distance, "the distance");
  OrderedParts<BodyNearPair> parts;
  const auto add = [&](const std::vector<NearPair>& pairs, const auto& whose) {
    for (const NearPair& pair : pairs) parts.add(named<BodyNearPair>(pair, whose));
    parts.end_part();
  };
  for_each_by_itself([&](BodyId id, Body& body, Detector& itself) {
    add(itself.pairs_within(body.deforming()->start, distance), id);
    return true;
  });
  ask_at_rest(distance, [&](Gathered& gathered) {
    add(gathered.detector().pairs_within(gathered.start(bodies), distance), gathered);
  });
  return std::move(parts).merged();
}

std::vector<BodyIntersection> World::State::intersections() {
  OrderedParts<BodyIntersection> parts;
  for_each_by_itself([&](BodyId id, Body& body, Detector& itself) {
    for (const Intersection& one : itself.intersections(body.deforming()->start)) parts.add({one, twice(id)});
    parts.end_part();
    return true;
  });
  ask_at_rest(0, [&](Gathered& gathered) {
    const auto state = gathered.locked();
    for (const Intersection& one : state->find_intersections(gathered.start(bodies), Question::all_contacts, true))
      parts.add(gathered.named(one));
    parts.end_part();
  });
  return std::move(parts).merged();
}

bool World::State::has_intersection() {
  bool has_one = false;
  ask_at_rest(0, [&](Gathered& gathered) {
    has_one = !gathered.locked()->find_intersections(gathered.start(bodies), Question::is_free, true).empty();
  });
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
  const auto take = [&](const SafeStep& step, const auto& whose) {
    first.upper = std::min(first.upper, step.upper);
    take_sooner(first.pair, first.lower, step.pair, step.lower, whose);
    return true;
  };
  for_each_by_itself([&](BodyId id, Body& body, Detector& itself) {
    return take(itself.safe_step(body.step(), fraction, of_steps(asked)), id);
  });
  for_each_gathered(
      asked,
      [&](Gathered& gathered, const Step& step, const QueryOptions& how) {
        return take(gathered.detector().safe_step(step, fraction, how), gathered);
      },
      [&](Gathered& gathered, const CutPath& path, const QueryOptions& how) {
        return take(gathered.locked()->safe_step(path, fraction, how), gathered);
      });
  if (asked.at_start == AtStart::fail && first.pair && first.lower == 0)
    refuse_touching_start(first.pair->kind, first.pair->vertices, first.pair->bodies);
  return first;
}

}  // namespace tamis

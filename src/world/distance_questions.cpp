// pairs_within, intersections, has_intersection and safe_step of a world.
#include <algorithm>

#include "detect/validate.hpp"
#include "world/ordered_parts.hpp"
#include "world/world_state.hpp"

namespace tamis {

std::vector<BodyNearPair> World::State::pairs_within(double distance) {
  validate_distance(distance, "the distance");
  OrderedParts<BodyNearPair> parts;
  for_each_at_rest(distance, [&](const auto& state, const Positions& pose, const auto& whose) {
    for (const NearPair& pair : state->find_near(pose, distance)) parts.add(named<BodyNearPair>(pair, whose));
    parts.end_part();
    return true;
  });
  return std::move(parts).merged();
}

std::vector<BodyIntersection> World::State::intersections() {
  OrderedParts<BodyIntersection> parts;
  for_each_at_rest(0, [&](const auto& state, const Positions& pose, const auto& whose) {
    for (const Intersection& one : state->find_intersections(pose, Question::all_contacts))
      parts.add(named<BodyIntersection>(one, whose));
    parts.end_part();
    return true;
  });
  return std::move(parts).merged();
}

bool World::State::has_intersection() {
  bool has_one = false;
  for_each_at_rest(0, [&](const auto& state, const Positions& pose, const auto&) {
    has_one = !state->find_intersections(pose, Question::is_free).empty();
    return !has_one;
  });
  return has_one;
}

/// A pair that starts at the distance d, beyond the separation, and keeps no more than f d has come f w / (1 - f) near,
/// w being how far both bodies go.
BodyStep World::State::safe_step(double fraction, const QueryOptions& asked) {
  validate_kept(fraction);
  validate_of_path(asked);
  BodyStep first;
  for_each_moving({separation(asked), fraction / (1 - fraction)}, asked,
                  [&](const auto& state, const auto& motion, const QueryOptions& how, const auto& whose) {
                    const SafeStep step = state->safe_step(motion, fraction, how);
                    first.upper = std::min(first.upper, step.upper);
                    take_sooner(first.pair, first.lower, step.pair, step.lower, whose);
                    return true;
                  });
  if (asked.at_start == AtStart::fail && first.pair && first.lower == 0)
    refuse_touching_start(first.pair->kind, first.pair->vertices, first.pair->bodies);
  return first;
}

}  // namespace tamis

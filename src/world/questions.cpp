// The questions of a world.
#include <algorithm>

#include "detect/validate.hpp"
#include "world/answers.hpp"
#include "world/world_state.hpp"

namespace tamis {

std::vector<BodyContact> World::State::contacts(const QueryOptions& asked) {
  OrderedParts<BodyContact> parts;
  for_each_moving(asked, 0, [&](const auto& state, const auto& motion, const QueryOptions& how, const auto& whose) {
    parts.add(state->find_contacts(motion, how), whose);
    return true;
  });
  std::vector<BodyContact> all = std::move(parts).merged();
  for (const BodyContact& c : all) check_start(c, c.toi_lower, asked);
  return all;
}

EarliestBodyContact World::State::earliest(const QueryOptions& asked) {
  EarliestBodyContact first;
  for_each_moving(asked, 0, [&](const auto& state, const auto& motion, const QueryOptions& how, const auto& whose) {
    const EarliestContact found = state->earliest(motion, how);
    first.toi_upper = std::min(first.toi_upper, found.toi_upper);
    keep_earlier(first.contact, first.toi_lower, found.contact, found.toi_lower, whose);
    return true;
  });
  if (first.contact) check_start(*first.contact, first.toi_lower, asked);
  return first;
}

bool World::State::is_free(const QueryOptions& asked) {
  if (asked.at_start == AtStart::fail) return !earliest(asked).contact;
  bool is_free = true;
  for_each_moving(asked, 0, [&](const auto& state, const auto& motion, const QueryOptions& how, const auto&) {
    return is_free = state->is_free(motion, how);
  });
  return is_free;
}

/// A pair of clearance c that keeps no more than f c has lost (1 - f) c, at most the displacements w of both bodies:
/// then it has come within f w / (1 - f) of its separation.
BodyStep World::State::safe_step(double fraction, const QueryOptions& asked) {
  validate_kept(fraction);
  BodyStep first;
  for_each_moving(asked, fraction / (1 - fraction),
                  [&](const auto& state, const auto& motion, const QueryOptions& how, const auto& whose) {
                    const SafeStep step = state->safe_step(motion, fraction, how);
                    first.upper = std::min(first.upper, step.upper);
                    keep_earlier(first.pair, first.lower, step.pair, step.lower, whose);
                    return true;
                  });
  if (first.pair) check_start(*first.pair, first.lower, asked);
  return first;
}

std::vector<BodyNearPair> World::State::pairs_within(double distance) {
  validate_distance(distance, "the distance");
  OrderedParts<BodyNearPair> parts;
  for_each_at_rest(distance, [&](const auto& state, const Positions& pose, const auto& whose) {
    parts.add(state->find_near(pose, distance), whose);
    return true;
  });
  return std::move(parts).merged();
}

std::vector<BodyIntersection> World::State::intersections() {
  OrderedParts<BodyIntersection> parts;
  for_each_at_rest(0, [&](const auto& state, const Positions& pose, const auto& whose) {
    parts.add(state->find_intersections(pose, Question::all_contacts), whose);
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

}  // namespace tamis

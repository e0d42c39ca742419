// Whether bodies overlap: they pass through each other, or one is inside another.
#include "search/query/cancellation.hpp"
#include "search/topology/at.hpp"
#include "worlds/containment.hpp"
#include "worlds/world_state.hpp"

namespace tamis {

bool World::has_overlap(const PoseOptions& asked) {
  return State::QuestionTurn(*this)->overlapping_pair(asked).has_value();
}

std::optional<BodyPair> World::State::overlapping_pair(const PoseOptions& asked) {
  const auto pair = intersecting_pair(asked, Question::is_free);
  return pair ? pair : enclosing_pair(asked);
}

std::optional<BodyPair> World::State::enclosing_pair(const PoseOptions& asked) {
  const NearDistance touching{.is_at_start = true, .include_static = asked.include_static};
  for (const auto& [a, b] : near_bodies(touching)) {
    const Body &first = *bodies[at(a)], &second = *bodies[at(b)];
    stop_if_cancelled(options);
    if (encloses(first, second, options) || encloses(second, first, options)) return BodyPair{a, b};
  }
  return std::nullopt;
}

bool World::is_closed(BodyId body) const {
  const State::Turn now(*this);
  return tamis::is_closed(now->body(body));
}

}  // namespace tamis

// Whether bodies overlap: they pass through each other, or one is inside another.
#include "search/query/cancellation.hpp"
#include "search/topology/at.hpp"
#include "worlds/containment.hpp"
#include "worlds/world_state.hpp"

namespace tamis {

bool World::has_overlap(const PoseOptions& asked) {
  const State::QuestionTurn now(*this);
  return now->has_intersection(asked) || now->has_containment(asked);
}

bool World::State::has_containment(const PoseOptions& asked) {
  const NearDistance touching{.is_at_start = true, .include_static = asked.include_static};
  for (const auto& [a, b] : near_bodies(touching)) {
    const Body &first = *bodies[at(a)], &second = *bodies[at(b)];
    stop_if_cancelled(options);
    if (encloses(first, second, options) || encloses(second, first, options)) return true;
  }
  return false;
}

bool World::is_closed(BodyId body) const {
  const State::Turn now(*this);
  return tamis::is_closed(now->body(body));
}

}  // namespace tamis

// The questions of a world.
#include <algorithm>

#include "api/detector_access.hpp"
#include "api/validate.hpp"
#include "tamis/error.hpp"
#include "worlds/answers.hpp"
#include "worlds/world_state.hpp"

namespace tamis {
namespace {

/// A detector's options for questions about steps, which have no tolerance.
QueryOptions of_steps(const PathOptions& asked) { return {asked.min_separation, of_curves(asked).at_start}; }

// The first contact of each pair of bodies, of a gathered mesh and of a body with itself.
const std::vector<Contact>& firsts_of(auto& state, auto& motion, auto& how, const Gathered& whose) {
  return state->first_contacts(motion, how, whose.body_pairs());
}
std::vector<Contact> firsts_of(auto& state, auto& motion, auto& how, BodyId) {
  const EarliestContact first = state->earliest(motion, how);
  return first.contact ? std::vector{*first.contact} : std::vector<Contact>();
}

}  // namespace

template <class Ask, class... Of>
bool World::State::ask_one(Detector& detector, const Ask& ask, const Of&... of) {
  const auto state = DetectorAccess::lock(detector);
  const bool goes_on = ask(state, of...);
  add_statistics(state->statistics);
  return goes_on;
}

template <class F>
void World::State::for_each_by_itself(const F& f) {
  for (std::size_t id = 0; id < bodies.size() && !only_pairs; ++id) {
    Body* body = bodies[id].get();
    if (!body || !body->is_enabled || !body->deforming() || !body->may_touch_itself) continue;
    if (!f(static_cast<BodyId>(id), *body)) return;
  }
}

template <class Ask>
bool World::State::ask_turning(Gathering& gathering, const BodyList& seen, const RigidChain& carrier,
                               const std::vector<BodyPair>& pairs, const NearDistance& distance,
                               const PathOptions& asked, const Ask& ask) {
  const std::vector<double> times = times_of_pieces(seen, pairs, distance);
  if (!gather(gathering, seen, distance, pairs, times)) return true;
  Gathered& gathered = *gathering.gathered;
  gathered.set_carrier(carrier);
  try {
    const RigidPath path = gathered.path(seen);
    const CutPath pieces{path, std::span(times).subspan(1)};
    return ask_one(gathered.detector(), ask, pieces, of_curves(asked), gathered);
  } catch (const InvalidPath&) {
    refuse_far(gathered);
    throw;
  }
}

template <class Ask>
void World::State::for_each_moving(const PathOptions& asked, double displacement_factor, const Ask& ask) {
  constexpr double kEndsOfStep[] = {0, 1};
  tamis::validate(asked);
  const NearDistance distance{asked.min_separation.value_or(options.min_separation), displacement_factor};
  const std::vector<BodyPair> near = near_bodies(distance);
  if (gather(straight_, bodies, distance, wanted_pairs(straight_, near), kEndsOfStep)) {
    Gathered& gathered = *straight_.gathered;
    if (!ask_one(gathered.detector(), ask, gathered.step(bodies), of_steps(asked), gathered)) return;
  }
  if (!ask_turning(turning_, bodies, {}, wanted_pairs(turning_, near), distance, asked, ask)) return;
  for (const CarriedPairs& carried : carried_pairs(bodies, near)) {
    const std::pair key(carried.carrier.size(), carried.pairs.front()[0]);
    Gathering& gathering =
        carried_.try_emplace(key, Gathering{MotionKind::turning, MotionKind::turning, 0.5}).first->second;
    const std::vector<BodyId> gathered = gathering.gathered ? gathering.gathered->body_ids() : std::vector<BodyId>();
    const BodyList seen = carried.in_frame(bodies, gathered);
    if (!ask_turning(gathering, seen, carried.carrier, carried.pairs, distance, asked, ask)) return;
  }
  for_each_by_itself([&](BodyId id, Body& body) {
    return ask_one(body.self_detector(options), ask, body.step(), of_steps(asked), id);
  });
}

template <class Ask>
void World::State::for_each_at_rest(double distance, const PoseOptions& asked, const Ask& ask) {
  constexpr double kEndsOfRest[] = {0, 0};
  const NearDistance near{.separation = distance, .is_at_start = true, .include_static = asked.include_static};
  Gathering& gathering = asked.include_static ? at_rest_with_static_ : at_rest_;
  if (gather(gathering, bodies, near, near_bodies(near), kEndsOfRest)) {
    Gathered& gathered = *gathering.gathered;
    if (!ask_one(gathered.detector(), ask, gathered.start(bodies), gathered)) return;
  }
  for_each_by_itself([&](BodyId id, Body& body) {
    return ask_one(body.self_detector(options), ask, Positions(body.deforming()->start), id);
  });
}

std::vector<BodyContact> World::contacts(const PathOptions& asked) {
  const State::QuestionTurn now(*this);
  std::vector<BodyContact> all;
  now->for_each_moving(asked, 0, [&](auto& state, auto& motion, auto& how, auto& whose) {
    add_named(all, state->find_contacts(motion, how), whose);
    return true;
  });
  put_in_order(all);
  for (const BodyContact& c : all) State::check_start(c, c.toi_lower, asked);
  return all;
}

std::vector<BodyContact> World::first_contacts(const PathOptions& asked) {
  const State::QuestionTurn now(*this);
  std::vector<BodyContact> all;
  now->for_each_moving(asked, 0, [&](auto& state, auto& motion, auto& how, auto& whose) {
    add_named(all, firsts_of(state, motion, how, whose), whose);
    return true;
  });
  std::ranges::sort(all, {}, [](const BodyContact& c) { return std::minmax(c.bodies[0], c.bodies[1]); });
  for (const BodyContact& c : all) State::check_start(c, c.toi_lower, asked);
  return all;
}

EarliestBodyContact World::earliest(const PathOptions& asked) { return State::QuestionTurn(*this)->earliest(asked); }

EarliestBodyContact World::State::earliest(const PathOptions& asked) {
  EarliestBodyContact first;
  for_each_moving(asked, 0, [&](auto& state, auto& motion, auto& how, auto& whose) {
    const EarliestContact found = state->earliest(motion, how);
    first.toi_upper = std::min(first.toi_upper, found.toi_upper);
    keep_earlier(first.contact, first.toi_lower, found.contact, found.toi_lower, whose);
    return true;
  });
  if (first.contact) check_start(*first.contact, first.toi_lower, asked);
  return first;
}

bool World::is_free(const PathOptions& asked) {
  if (asked.at_start == AtStart::fail) return !earliest(asked).contact;
  return State::QuestionTurn(*this)->is_free(asked);
}

bool World::State::is_free(const PathOptions& asked) {
  bool is_free = true;
  for_each_moving(asked, 0,
                  [&](auto& state, auto& motion, auto& how, auto&) { return is_free = state->is_free(motion, how); });
  return is_free;
}

/// A pair of clearance c that keeps no more than f c has lost (1 - f) c, at most the displacements w of both bodies.
/// Then it has come within f w / (1 - f) of its separation.
BodyStep World::safe_step(double fraction, const PathOptions& asked) {
  const State::QuestionTurn now(*this);
  validate_kept(fraction);
  BodyStep first;
  now->for_each_moving(asked, fraction / (1 - fraction), [&](auto& state, auto& motion, auto& how, auto& whose) {
    const SafeStep step = state->safe_step(motion, fraction, how);
    first.toi_upper = std::min(first.toi_upper, step.toi_upper);
    keep_earlier(first.pair, first.toi_lower, step.pair, step.toi_lower, whose);
    return true;
  });
  if (first.pair) State::check_start(*first.pair, first.toi_lower, asked);
  return first;
}

std::vector<BodyNearPair> World::pairs_within(double distance, const PoseOptions& asked) {
  const State::QuestionTurn now(*this);
  validate_distance(distance, "the distance");
  std::vector<BodyNearPair> all;
  now->for_each_at_rest(distance, asked, [&](auto& state, auto& pose, auto& whose) {
    add_named(all, state->find_near(pose, distance), whose);
    return true;
  });
  put_in_order(all);
  return all;
}

std::vector<BodyIntersection> World::intersections(const PoseOptions& asked) {
  const State::QuestionTurn now(*this);
  std::vector<BodyIntersection> all;
  now->for_each_at_rest(0, asked, [&](auto& state, auto& pose, auto& whose) {
    add_named(all, state->find_intersections(pose, Question::all_contacts, true), whose);
    return true;
  });
  put_in_order(all);
  return all;
}

bool World::has_intersection(const PoseOptions& asked) {
  return State::QuestionTurn(*this)->intersecting_pair(asked, Question::is_free).has_value();
}

std::optional<BodyPair> World::State::intersecting_pair(const PoseOptions& asked, Question question) {
  std::vector<BodyIntersection> found;
  const auto pair_of = [](const BodyIntersection& row) {
    return BodyPair{std::min(row.bodies[0], row.bodies[1]), std::max(row.bodies[0], row.bodies[1])};
  };
  for_each_at_rest(0, asked, [&](auto& state, auto& pose, auto& whose) {
    add_named(found, state->find_intersections(pose, question, true), whose);
    return found.empty() || question != Question::is_free;
  });
  const auto first = std::ranges::min_element(found, {}, pair_of);
  return first == found.end() ? std::nullopt : std::optional(pair_of(*first));
}

}  // namespace tamis

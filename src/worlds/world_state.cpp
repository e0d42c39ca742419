#include "worlds/world_state.hpp"

#include <algorithm>
#include <limits>

#include "api/pair_faults.hpp"
#include "api/validate.hpp"
#include "numbers/held_bytes.hpp"
#include "search/query/stage_counts.hpp"
#include "search/topology/at.hpp"
#include "tamis/error.hpp"

namespace tamis {
namespace {

Options valid(Options options) {
  const PairFilter& filter = options.filter;
  if (!filter.group_of_vertex.empty() || !filter.groups_may_touch.empty() || filter.group_count != 1 || filter.accepts)
    throw InvalidOptions(
        "the options of a world have groups or a function that accepts pairs, which are about one "
        "mesh: say which bodies may touch by set_may_touch");
  if (!options.radii.empty())
    throw InvalidOptions(
        "the options of a world have radii, which are one a group of one mesh: give each body its own by "
        "set_radius");
  validate(options, Mesh(1, {}, {}, {0}));
  return options;
}

}  // namespace

World::State::State(Options o) : options(valid(std::move(o))) {}

Body& World::State::body(BodyId id) {
  if (id < 0 || at(id) >= bodies.size())
    throw InvalidOptions("the world has no body " + std::to_string(id) + ": give a number that `add` has returned");
  if (!bodies[at(id)])
    throw InvalidOptions("body " + std::to_string(id) + " has been removed: name one that is still there");
  return *bodies[at(id)];
}

void World::State::move(BodyId id, BodyMotion motion) { become(body(id), body(id).moved(std::move(motion))); }

void World::State::become(Body& body, Body moved) noexcept {
  forget_if_still(body);
  body.become(std::move(moved));
  forget_if_still(body);
}

std::vector<BodyId> World::State::add(const std::shared_ptr<const BodyShape>& shape, std::vector<BodyMotion> motions) {
  if (motions.size() > at(std::numeric_limits<BodyId>::max()) - bodies.size())
    throw InvalidOptions("the world has had 2^31 - 1 bodies, and numbers are not given twice: make another world");
  std::vector<BodyId> ids;
  BodyList added;
  for (BodyMotion& motion : motions) {
    ids.push_back(static_cast<BodyId>(bodies.size() + added.size()));
    added.push_back(std::make_unique<Body>(ids.back(), shape, std::move(motion)));
  }
  if (bodies.capacity() < bodies.size() + added.size())
    bodies.reserve(std::max(2 * bodies.size(), bodies.size() + added.size()));
  for (std::unique_ptr<Body>& body : added) forget_if_still(*bodies.emplace_back(std::move(body)));
  return ids;
}

void World::State::move(std::span<const BodyId> ids, std::vector<BodyMotion> motions) {
  if (ids.size() != motions.size())
    throw InvalidOptions("there are " + std::to_string(ids.size()) + " bodies and " + std::to_string(motions.size()) +
                         " motions: give one for each body");
  refuse_twice(ids);
  std::vector<Body> moved;
  for (std::size_t i = 0; i < ids.size(); ++i) moved.push_back(body(ids[i]).moved(std::move(motions[i])));
  for (std::size_t i = 0; i < ids.size(); ++i) become(body(ids[i]), std::move(moved[i]));
}

void World::State::set_may_touch(std::span<const BodyPair> pairs, bool may_touch) {
  for (const auto& [a, b] : pairs) require_may_touch(a, b, may_touch);
  std::set<BodyPair> excluded = excluded_pairs;
  for (const auto& [a, b] : pairs) {
    if (a == b) continue;
    const BodyPair pair{std::min(a, b), std::max(a, b)};
    if (may_touch)
      excluded.erase(pair);
    else
      excluded.insert(pair);
  }
  // Nothing below can fail.
  if (excluded != excluded_pairs) drop_gathered();
  excluded_pairs.swap(excluded);
  for (const auto& [a, b] : pairs)
    if (a == b) body(a).may_touch_itself = may_touch;
}

void World::State::require_may_touch(BodyId a, BodyId b, bool may_touch) {
  const Body &first = body(a), &second = body(b);
  if (may_touch && &first == &second && !first.deforming())
    throw InvalidOptions("body " + std::to_string(a) + " does not deform, so it cannot touch itself: leave that out");
}

void World::State::refuse_twice(std::span<const BodyId> ids) {
  std::vector<BodyId> ordered(ids.begin(), ids.end());
  std::ranges::sort(ordered);
  const auto twice = std::ranges::adjacent_find(ordered);
  if (twice != ordered.end())
    throw InvalidOptions("body " + std::to_string(*twice) + " is named twice: give each once");
}

void World::State::drop_gathered() {
  for (Gathering* gathering : {&straight_, &turning_, &at_rest_, &at_rest_with_static_}) gathering->gathered = nullptr;
  carried_.clear();
}

void World::State::forget_gathered(const Body& changed) {
  drop_gathered();
  forget_if_still(changed);
}

void World::State::refuse_touching_start(PairKind kind, const PairVertices& vertices, const std::array<BodyId, 2>& of) {
  const auto& [a, b] = of;
  const std::string which =
      a == b ? "body " + std::to_string(a) : "bodies " + std::to_string(a) + " and " + std::to_string(b);
  throw InvalidStep(features_text(kind, vertices) + " of " + which +
                    " touch at the start, or are nearer than can be told: move them apart, keep the bodies apart by "
                    "set_may_touch, or pass at_start ignore");
}

void World::State::refuse_far(const Gathered& gathered) const {
  for (const auto& [id, unused] : gathered.items().of_body)
    if (!bodies[at(id)]->is_surely_representable())
      throw InvalidPath("body " + std::to_string(id) +
                        " goes farther than doubles can follow beside bodies that turn: give shorter positions");
}

void World::State::add_statistics(const Statistics& of_part) {
  statistics.isa = of_part.isa;
  statistics.threads = std::max(statistics.threads, of_part.threads);
  for (const StageCount& stage : of_part.stages) tamis::add(statistics.stages, stage);
  statistics.decided_by += of_part.decided_by;
  statistics.seconds += of_part.seconds;
  statistics.ignored += of_part.ignored;
  statistics.nodes_visited += of_part.nodes_visited;
  statistics.rebuilt |= of_part.rebuilt;
}

std::uint64_t World::State::memory_bytes() const {
  std::uint64_t bytes = held_bytes(bodies);
  for (const Gathering* gathering : {&straight_, &turning_, &at_rest_, &at_rest_with_static_})
    bytes += held_bytes(*gathering);
  for (const auto& [key, gathering] : carried_) bytes += held_bytes(gathering);
  return bytes;
}

}  // namespace tamis

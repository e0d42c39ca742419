#include "world/world_state.hpp"

#include <algorithm>

#include "detect/pair_faults.hpp"
#include "detect/validate.hpp"
#include "numerics/held_bytes.hpp"
#include "query/stage_counts.hpp"
#include "tamis/error.hpp"
#include "topology/at.hpp"

namespace tamis {
namespace {

Options valid(Options options) {
  const PairFilter& filter = options.filter;
  if (!filter.group_of_vertex.empty() || !filter.groups_may_touch.empty() || filter.group_count != 1 || filter.accepts)
    throw InvalidOptions(
        "the options of a world have groups or a function that accepts pairs, which speak of one "
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

void World::State::move(BodyId id, BodyMotion motion) {
  Body& moved = body(id);
  forget_if_still(moved);
  moved.move(std::move(motion));
  forget_if_still(moved);
}

void World::State::forget_gathered(const Body& changed) {
  for (Gathering* gathering : {&straight_, &turning_, &at_rest_}) gathering->gathered = nullptr;
  carried_.clear();
  forget_if_still(changed);
}

void World::State::refuse_touching_start(PairKind kind, const PairVertices& vertices, const std::array<BodyId, 2>& of) {
  const auto& [a, b] = of;
  const std::string which =
      a == b ? "body " + std::to_string(a) : "bodies " + std::to_string(a) + " and " + std::to_string(b);
  throw InvalidStep(features_text(kind, vertices) + " of " + which +
                    " touch at the start, or are nearer than can be told: move them apart, keep the bodies apart by "
                    "set_may_touch, or ask with at_start ignore");
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
  for (const Gathering* gathering : {&straight_, &turning_, &at_rest_}) bytes += held_bytes(*gathering);
  for (const auto& [key, gathering] : carried_) bytes += held_bytes(gathering);
  return bytes;
}

}  // namespace tamis

// Many motions of the same bodies in one question. Threads share the motions, each with a world of its own.
#include <algorithm>

#include "api/validate.hpp"
#include "numbers/parallel.hpp"
#include "numbers/pool.hpp"
#include "tamis/error.hpp"
#include "worlds/world_state.hpp"

namespace tamis {
namespace {

Options with_one_thread(Options options) {
  options.threads = 1;
  return options;
}

/// Calls check(); an InvalidStep that it throws is thrown again with the motion's number.
template <class Check>
void of_motion(std::size_t motion, const Check& check) {
  try {
    check();
  } catch (const InvalidStep& error) {
    throw InvalidStep("motion " + std::to_string(motion) + ": " + error.what());
  }
}

}  // namespace

World::State::State(const State& other)
    : options(with_one_thread(other.options)), excluded_pairs(other.excluded_pairs) {
  for (const auto& body : other.bodies) bodies.push_back(body ? std::make_unique<Body>(*body) : nullptr);
}

void World::State::validate(std::span<const BodyId> moved, std::span<const BodyMotion> motions) {
  refuse_twice(moved);
  for (const BodyId id : moved) body(id);
  if (moved.empty() ? !motions.empty() : motions.size() % moved.size() != 0)
    throw InvalidOptions(std::to_string(motions.size()) + " motions for " + std::to_string(moved.size()) +
                         " bodies: give one motion for each body, for each query");
  for (std::size_t i = 0; i < motions.size(); ++i)
    of_motion(i / moved.size(), [&] { body(moved[i % moved.size()]).validate(motions[i]); });
}

std::vector<EarliestBodyContact> World::earliest_many(std::span<const BodyId> moved,
                                                      std::span<const BodyMotion> motions, const PathOptions& asked) {
  const State::QuestionTurn turn(*this);
  State& now = *turn;
  validate(asked);
  now.validate(moved, motions);
  const PathOptions of_each = of_curves(asked);
  std::vector<EarliestBodyContact> found(motions.empty() ? 0 : motions.size() / moved.size());
  Pool<State> worlds([&](std::size_t) { return std::make_unique<State>(now); });
  Arena(now.options).run([&] {
    parallel_for(found.size(), 1, [&](std::size_t i, std::size_t end) {
      const auto mine = worlds.take();
      for (; i != end; ++i) {
        for (std::size_t k = 0; k < moved.size(); ++k) mine->move(moved[k], motions[i * moved.size() + k]);
        found[i] = mine->earliest(of_each);
      }
    });
    now.statistics.threads = threads_here();
  });
  for (const auto& world : worlds.all()) now.add_statistics(world->statistics);
  for (std::size_t i = 0; i < found.size(); ++i)
    of_motion(i, [&] {
      if (found[i].contact) State::check_start(*found[i].contact, found[i].toi_lower, asked);
    });
  return found;
}

}  // namespace tamis

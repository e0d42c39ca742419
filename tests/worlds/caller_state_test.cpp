// A world's answers do not depend on the floating-point state of the caller. Bug: as of a detector.
#include <gtest/gtest.h>

#include "support/caller_states.hpp"
#include "worlds/random_world.hpp"
#include "worlds/world_numbers.hpp"

namespace tamis::test {
namespace {

TEST(WorldInCallersState, AnswersAlike) {
  for (const std::uint64_t seed : {std::uint64_t{3}, std::uint64_t{4}}) {
    const TestWorld given = random_world(seed, 2, seed % 2 ? Motions::any : Motions::straight);
    for (const int threads : {0, 1, 4})
      expect_same_in_all_states("seed " + std::to_string(seed) + ", threads " + std::to_string(threads), [&] {
        Options options;
        options.threads = threads;
        World world(options);
        std::vector<BodyId> ids;
        for (const auto& body : given.bodies) {
          const Shape shape(body.shape.mesh(), body.shape.points());
          ids.push_back(world.add(shape, body.motion));
          world.set_radius(ids.back(), 0.0078125);
        }
        Numbers numbers = numbers_of(world, ids, 0.125);
        const std::vector<BodyMotion> motions{given.bodies[0].motion, given.bodies[1].motion};
        for (const EarliestBodyContact& first : world.earliest_many(std::vector{ids[0]}, motions))
          append(numbers, first);
        for (std::size_t i = 0; i < ids.size(); ++i) world.move(ids[i], given.bodies[i].motion);
        const Numbers again = numbers_of(world, ids, 0.125);
        numbers.insert(numbers.end(), again.begin(), again.end());
        return numbers;
      });
  }
}

}  // namespace
}  // namespace tamis::test

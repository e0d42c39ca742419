// Many motions in one question: each has the answer that it has alone, whatever the threads.
#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "tamis/error.hpp"
#include "worlds/random_world.hpp"

namespace tamis::test {
namespace {

/// So far apart that some motions are free.
constexpr double kSize = 5;

/// Motions of the first two bodies that move.
struct Asked {
  std::vector<BodyId> bodies;
  std::vector<BodyMotion> motions;
};
Asked random_motions(const TestWorld& world, std::uint64_t seed, Motions kinds) {
  Random random(seed);
  Asked asked{{0, 1}, {}};
  for (int i = 0; i < 12; ++i)
    for (const BodyId body : asked.bodies)
      asked.motions.push_back(random_motion(random, world.bodies[place(body)].shape, kSize, kinds));
  return asked;
}

void expect_as_alone(Motions kinds) {
  std::size_t free = 0, touching = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    Options three = one_thread();
    three.threads = 3;
    TestWorld world = random_world(seed, kSize, kinds), of_threads = random_world(seed, kSize, kinds, three);
    const Asked asked = random_motions(world, seed, kinds);
    const EarliestBodyContact before = world.world.earliest();
    const std::vector<EarliestBodyContact> found = world.world.earliest_many(asked.bodies, asked.motions);
    const std::vector<EarliestBodyContact> shared = of_threads.world.earliest_many(asked.bodies, asked.motions);
    ASSERT_EQ(found.size(), 12u);
    ASSERT_EQ(shared.size(), 12u);
    expect_same_bits(world.world.earliest(), before);  // it goes on as it was told
    for (std::size_t i = 0; i < found.size(); ++i) {
      SCOPED_TRACE(i);
      expect_same_bits(found[i], shared[i]);
      for (std::size_t k = 0; k < 2; ++k) world.move(asked.bodies[k], asked.motions[2 * i + k]);
      expect_same_bits(found[i], world.world.earliest());
      ++(found[i].contact ? touching : free);
    }
  }
  EXPECT_GT(free, 5u);
  EXPECT_GT(touching, 20u);
}

TEST(ManyMotions, HaveTheAnswersThatTheyHaveAloneOnStraightWays) { expect_as_alone(Motions::straight); }
TEST(ManyMotions, HaveTheAnswersThatTheyHaveAloneOnCurves) { expect_as_alone(Motions::any); }

template <class Error>
void expect_message(const std::function<void()>& call, const std::string& part) {
  try {
    call();
    ADD_FAILURE() << "not refused: " << part;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(ManyMotions, AreRefusedByNameAndChangeNothing) {
  TestWorld world = random_world(1, 2, Motions::any);
  const EarliestBodyContact before = world.world.earliest();
  const std::vector<BodyMotion> still(6, Static{});
  const auto ask = [&](std::vector<BodyId> bodies, const std::vector<BodyMotion>& motions) {
    return [&world, bodies, motions] { static_cast<void>(world.world.earliest_many(bodies, motions)); };
  };
  expect_message<InvalidOptions>(ask({0, 99}, still), "no body 99");
  expect_message<InvalidOptions>(ask({1, 0, 1}, still), "body 1 is named twice: give each once");
  expect_message<InvalidOptions>(ask({0, 1, 2, 3}, still), "6 motions for 4 bodies: give one motion for each body");
  expect_message<InvalidOptions>(ask({}, still), "6 motions for 0 bodies");
  std::vector<BodyMotion> bad = still;
  bad[3] = Rigid{{{{{0, 0, 0}, {}}, {{0, std::nan(""), 0}, {}}}}};
  expect_message<InvalidStep>(ask({0, 1}, bad), "motion 1: a pose of body 1 is not finite");
  EXPECT_TRUE(world.world.earliest_many({}, {}).empty());
  EXPECT_TRUE(world.world.earliest_many(std::vector<BodyId>{0}, {}).empty());
  expect_same_bits(world.world.earliest(), before);
}

/// Bug: what a copy of a world forgets.
TEST(ManyMotions, KnowWhatTheWorldWasTold) {
  const Shape plate(Mesh(3, {{0, 1, 2}}), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  World world(one_thread());
  const BodyId below = world.add(plate, Static{}), off = world.add(plate, Static{{{0, 0, 0.5}, {}}});
  const BodyId moving = world.add(plate, Static{{{0, 0, 9}, {}}}), removed = world.add(plate, Static{});
  world.set_enabled(off, false);
  world.remove(removed);
  const std::vector<BodyMotion> down{Rigid{interpolated_chain({{0.1, 0.1, 2}, {}}, {{0.1, 0.1, 0.25}, {}})}};
  const auto first = [&] { return world.earliest_many(std::vector{moving}, down)[0]; };
  EXPECT_FALSE(first().contact);
  world.set_radius(below, 0.5);
  ASSERT_TRUE(first().contact);
  EXPECT_NEAR(first().toi_lower, 6. / 7, 1e-9);
  world.set_may_touch(below, moving, false);
  EXPECT_FALSE(first().contact);
  world.set_enabled(off, true);
  EXPECT_TRUE(first().contact);
}

/// A plate that the second motion begins in touch with.
TEST(ManyMotions, FailForWhatTouchesAtTheStart) {
  const Shape plate(Mesh(3, {{0, 1, 2}}), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  World world(one_thread());
  world.add(plate, Static{});
  const BodyId moving = world.add(plate, Static{});
  const auto up_from = [](double z) -> BodyMotion {
    return Rigid{interpolated_chain({{0.1, 0.1, z}, {}}, {{0.1, 0.1, 2}, {}})};
  };
  const std::vector<BodyMotion> motions{up_from(1), up_from(0)};
  const std::vector<EarliestBodyContact> found = world.earliest_many(std::vector{moving}, motions);
  EXPECT_FALSE(found[0].contact);
  EXPECT_EQ(found[1].toi_lower, 0);
  PathOptions options;
  options.at_start = AtStart::ignore;
  EXPECT_FALSE(world.earliest_many(std::vector{moving}, motions, options)[1].contact);
  options.at_start = AtStart::fail;
  expect_message<InvalidStep>([&] { static_cast<void>(world.earliest_many(std::vector{moving}, motions, options)); },
                              "of bodies 1 and 0 touch at the start");
}

TEST(ManyMotions, EndWhereTheyAreCancelled) {
  Options options = one_thread();
  options.threads = 2;
  std::atomic<int> asked = 0;
  options.is_cancelled = [&] { return ++asked > 5; };
  TestWorld world = random_world(2, 2, Motions::any, options);
  const Asked many = random_motions(world, 2, Motions::any);
  EXPECT_THROW(static_cast<void>(world.world.earliest_many(many.bodies, many.motions)), Cancelled);
}

}  // namespace
}  // namespace tamis::test

// The first contact of each pair of bodies is, to the last bit, the first of all its contacts.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <tuple>

#include "scenes/machines.hpp"
#include "support/contact_bits.hpp"
#include "tamis/error.hpp"
#include "worlds/random_world.hpp"

namespace tamis::test {
namespace {

using scenes::Machine;
using BodyPair = std::array<BodyId, 2>;
using Bits = std::array<double, 13>;

BodyPair pair_of(const BodyContact& c) {
  return {std::min(c.bodies[0], c.bodies[1]), std::max(c.bodies[0], c.bodies[1])};
}

/// By time, then by the documented order of contacts.
bool begins_before(const BodyContact& a, const BodyContact& b) {
  return std::tuple(a.toi_lower, named(a), a.toi_upper) < std::tuple(b.toi_lower, named(b), b.toi_upper);
}

std::map<BodyPair, BodyContact> firsts_of(const std::vector<BodyContact>& contacts) {
  std::map<BodyPair, BodyContact> firsts;
  for (const BodyContact& c : contacts) {
    const auto [known, is_new] = firsts.try_emplace(pair_of(c), c);
    if (!is_new && begins_before(c, known->second)) known->second = c;
  }
  return firsts;
}

void expect_same(const std::vector<BodyContact>& found, const std::map<BodyPair, BodyContact>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  auto each = expected.begin();
  for (const BodyContact& c : found) {
    EXPECT_EQ(pair_of(c), each->first);
    EXPECT_EQ(c.bodies, each->second.bodies);
    const Bits bits = bits_of(c), bits_expected = bits_of(each++->second);
    EXPECT_EQ(bits, bits_expected) << c.bodies[0] << " and " << c.bodies[1];
  }
}

/// Of a world that has answered other questions, with one thread, and of a new one with four.
std::size_t expect_first_of_all(TestWorld& kept, const PathOptions& asked = {}) {
  Options four;
  four.threads = 4;
  World fresh(four);
  for (const TestBody& body : kept.bodies) {
    const BodyId id = fresh.add(body.shape, body.motion);
    fresh.set_radius(id, body.radius);
  }
  const auto expected = firsts_of(kept.world.contacts(asked));
  expect_same(kept.world.first_contacts(asked), expected);
  expect_same(fresh.first_contacts(asked), expected);
  const std::vector<BodyContact> found = kept.world.first_contacts(asked);
  const auto first = std::ranges::min_element(found, begins_before);
  const EarliestBodyContact earliest = kept.world.earliest(asked);
  EXPECT_EQ(earliest.contact.has_value(), first != found.end());
  if (earliest.contact && first != found.end()) {
    EXPECT_EQ(bits_of(*earliest.contact), bits_of(*first));
  }
  return expected.size();
}

std::size_t touching_pairs(double size, Motions motions, const PathOptions& asked, double radius = 0) {
  std::size_t pairs = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    TestWorld world = random_world(seed, size, motions);
    for (BodyId id = 0; place(id) < world.bodies.size(); id += 2) world.set_radius(id, radius);
    pairs += expect_first_of_all(world, asked);
  }
  return pairs;
}

TEST(FirstContacts, AreTheFirstOfAllWhereBodiesGoStraight) {
  EXPECT_GT(touching_pairs(1.5, Motions::straight, {}), 60u);
}
TEST(FirstContacts, AreTheFirstOfAllOnCurves) { EXPECT_GT(touching_pairs(2, Motions::any, {}), 40u); }
TEST(FirstContacts, AreTheFirstOfAllWithinASeparation) {
  EXPECT_GT(touching_pairs(2.5, Motions::straight, {.min_separation = 0.02}, 0.05), 30u);
  EXPECT_GT(touching_pairs(2.5, Motions::any, {.min_separation = 0.02}, 0.05), 30u);
}
TEST(FirstContacts, AreTheFirstOfAllWhosePairsWereApart) {
  EXPECT_GT(touching_pairs(1, Motions::straight, {.min_separation = 0.01, .at_start = AtStart::ignore}), 60u);
  EXPECT_GT(touching_pairs(1, Motions::any, {.min_separation = 0.01, .at_start = AtStart::ignore}), 60u);
}

/// Brackets are wide, so they overlap.
TEST(FirstContacts, AreTheFirstOfAllWithAWideTolerance) {
  EXPECT_GT(touching_pairs(2, Motions::any, {.tolerance = 0.05}), 40u);
}

TEST(FirstContacts, StepAfterStep) {
  for_each_step([](TestWorld& world) { expect_first_of_all(world); });
}

/// A plate over which others come down, one after another: what touches first must not end the search for the rest.
TEST(FirstContacts, OfEachPairHoweverLate) {
  const Shape plate({3, {{0, 1, 2}}}, {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}}),
      blade({3, {{0, 1, 2}}}, {{1, 1, 0}, {2, 1, 1}, {1, 2, 1}});
  for (const double turn : {0.0, 0.1}) {
    World world;
    world.add(plate, Static{});
    const auto down = [&](double from, const Point& aside) {
      return Rigid{
          interpolated_chain({{aside[0], aside[1], from}, {}}, {{aside[0], aside[1], from - 1}, {0, 0, turn}})};
    };
    world.add(blade, down(0.1, {0, 0, 0}));
    world.add(blade, down(0.9, {2, 0, 0}));
    const BodyId soft =
        world.add(blade, Deforming{{{1, 4, 0.5}, {2, 4, 1}, {1, 5, 1}}, {{1, 4, -0.5}, {2, 4, 1}, {1, 5, 1}}});
    world.add(blade, down(1.5, {4, 0, 0}));
    const auto found = world.first_contacts();
    const std::array expected{0.1, 0.9, 0.5};
    ASSERT_EQ(found.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(pair_of(found[i]), (BodyPair{0, static_cast<BodyId>(i + 1)}));
      EXPECT_NEAR(found[i].toi_lower, expected[i], 1e-6);
    }
    world.set_may_touch(0, soft, false);
    EXPECT_EQ(world.first_contacts().size(), 2u);
    world.set_enabled(1, false);
    EXPECT_EQ(world.first_contacts().size(), 1u);
  }
}

TEST(FirstContacts, OfABodyWithItself) {
  const Mesh two(6, {{0, 1, 2}, {3, 4, 5}});
  std::vector<Point> start{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, 0.5}, {0.4, 0.2, 0.6}, {0.2, 0.4, 0.7}},
      end = start;
  for (std::size_t v = 3; v < 6; ++v) end[v][2] -= 1;
  World world;
  world.add({two, start}, Deforming{start, end});
  const auto found = world.first_contacts();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].bodies, (BodyPair{0, 0}));
  EXPECT_NEAR(found[0].toi_lower, 0.5, 1e-9);
}

TEST(FirstContacts, AreRefusedWhereAPairTouchesAtTheStart) {
  const Shape plate({3, {{0, 1, 2}}}, {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}}), point({1, {}, {}, {0}}, {{1, 1, 0}});
  World world;
  world.add(plate, Static{});
  world.add(point, Rigid{interpolated_chain({}, {{0, 0, 1}, {}})});
  EXPECT_EQ(world.first_contacts().at(0).toi_upper, 0);
  EXPECT_TRUE(world.first_contacts({.at_start = AtStart::ignore}).empty());
  EXPECT_THROW((void)world.first_contacts({.at_start = AtStart::fail}), InvalidStep);
  EXPECT_THROW((void)world.first_contacts({.min_separation = -1}), InvalidOptions);
  EXPECT_THROW((void)world.first_contacts({.tolerance = 0}), InvalidOptions);
}

std::uint64_t decided(const World& world) {
  const PrecisionCount& by = world.statistics().decided_by;
  return by.lanes + by.scalar + by.exact + by.unresolved;
}

/// A gear from tools/scenes/, a little uneven, so that no two edges are parallel.
Shape gear(Index teeth, double radius) {
  const Machine train = scenes::gear_train(1, teeth, 0, false);
  std::vector<Point> points = train.shapes[0].points;
  Random random(static_cast<std::uint64_t>(teeth));
  for (Point& p : points) {
    const Point off = random.point(1e-4);
    p = {radius * (p[0] - 0.05 * p[2] * p[1]) + off[0], radius * (p[1] + 0.05 * p[2] * p[0]) + off[1], p[2] + off[2]};
  }
  return {Mesh(static_cast<Index>(points.size()), train.shapes[0].faces), points};
}

Rigid turning(const Point& place, double start, double turn) {
  return Rigid{{{{place, {0, 0, start}}, {place, {0, 0, start + turn}}}}};
}

/// Two gears of 1,120 and 1,920 triangles that turn through each other, and two smaller ones far from these that mesh.
void add_gears(World& world) {
  const double large = 240. / 140, away = 1 + large + 0.004;
  world.add(gear(140, 1), turning({0, 0, 0}, 0, 0.5));
  world.add(gear(240, large), turning({away, 0, 0}, std::numbers::pi + std::numbers::pi / 240, 0.5 * 140 / 240));
  const Shape small = gear(20, 1);
  world.add(small, turning({0, 0, 9}, 0, 0.3));
  world.add(small, turning({2.05, 0, 9}, std::numbers::pi + std::numbers::pi / 20, -0.3));
}

/// Bug: all contacts of a pair are decided, or of all pairs that touch as long as one is still free.
TEST(FirstContacts, OfGearsNeedFewDecisions) {
  World world(one_thread());
  add_gears(world);
  const PathOptions asked{.at_start = AtStart::ignore};
  EXPECT_GT(world.contacts(asked).size(), 3000u);
  const std::uint64_t by_all = decided(world);
  const std::vector<BodyContact> found = world.first_contacts(asked);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(pair_of(found[0]), (BodyPair{0, 1}));
  const PrecisionCount& by = world.statistics().decided_by;
  EXPECT_LE(by.scalar + by.exact + by.unresolved, 50u);
  EXPECT_LT(decided(world), by_all / 2) << "of " << by_all;
}

/// The same where all go straight: balls that fly through others, and one pair that only comes near.
TEST(FirstContacts, OfBallsCostAboutAsMuchAsTheEarliest) {
  const scenes::Shape sphere = scenes::unit_sphere(16);
  const Shape ball(Mesh(static_cast<Index>(sphere.points.size()), sphere.faces), sphere.points);
  World world(one_thread());
  for (int i = 0; i < 4; ++i) {
    world.add(ball, Static{{{0, 10.0 * i, 0}, {}}});
    const double aside = i == 3 ? 2.01 : 0.123;
    world.add(ball, Rigid{interpolated_chain({{3, 10 * i + aside, 0.2}, {}}, {{-3, 10 * i + aside, 0.2}, {}})});
  }
  const std::size_t all = world.contacts().size();
  const std::uint64_t by_all = decided(world);
  EXPECT_EQ(world.first_contacts().size(), 3u);
  EXPECT_GT(all, 10000u);
  EXPECT_LT(decided(world), by_all / 10) << "of " << by_all;
}

TEST(FirstContacts, AreCancelled) {
  long looks_left = 1 << 20, looks = 0;
  Options options = one_thread();
  options.is_cancelled = [&] { return ++looks, --looks_left < 0; };
  World world(options);
  add_gears(world);
  static_cast<void>(world.first_contacts());
  looks = 0;
  const auto expected = world.first_contacts();
  const long needed = looks;
  for (long after = 0; after < needed; after += 1 + needed / 7) {
    looks_left = after;
    EXPECT_THROW((void)world.first_contacts(), Cancelled);
  }
  looks_left = 1 << 20;
  const auto again = world.first_contacts();
  ASSERT_EQ(again.size(), expected.size());
  for (std::size_t i = 0; i < again.size(); ++i) EXPECT_EQ(bits_of(again[i]), bits_of(expected[i]));
}

}  // namespace
}  // namespace tamis::test

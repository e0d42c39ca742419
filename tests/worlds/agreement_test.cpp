// A world says what a detector says of all its bodies as one mesh.
#include <gtest/gtest.h>

#include <array>
#include <set>
#include <span>
#include <tuple>

#include "tamis/pair_distance.hpp"
#include "worlds/expect_agreement.hpp"

namespace tamis::test {
namespace {

TEST(World, AgreesWithOneMeshThatGoesStraight) {
  std::size_t contacts = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    TestWorld world = random_world(seed, 1.5, Motions::straight);
    contacts += expect_same_contacts(world);
    expect_same_first(world);
  }
  EXPECT_GT(contacts, 1000u);
}

TEST(World, AgreesWithOneMeshOnCurves) {
  std::size_t contacts = 0;
  for (std::uint64_t seed = 0; seed < 15; ++seed) {
    SCOPED_TRACE(seed);
    TestWorld world = random_world(seed, 2, Motions::any);
    contacts += expect_same_contacts(world);
    expect_same_first(world);
  }
  EXPECT_GT(contacts, 1000u);
}

/// Far from the origin, with turns by up to fifty radians, and of bodies a thousand times as large as others.
TEST(World, AgreesWhereItIsHard) {
  const std::array<Extremes, 3> kinds{{{{1e7, -3e6, 2e7}, 1, 1}, {{}, 20, 1}, {{}, 1, 1e-3}}};
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    std::size_t contacts = 0;
    for (std::uint64_t seed = 304; seed < 309; ++seed) {
      SCOPED_TRACE(testing::Message() << "kind " << kind << ", seed " << seed);
      TestWorld world = random_world(seed, 2.5, seed % 2 ? Motions::any : Motions::straight, one_thread(), kinds[kind]);
      contacts += expect_same_contacts(world);
      expect_same_first(world);
    }
    EXPECT_GT(contacts, 50u);
  }
}

TEST(World, AgreesWithinASeparation) {
  for (std::uint64_t seed = 100; seed < 110; ++seed) {
    SCOPED_TRACE(seed);
    TestWorld world = random_world(seed, 2.5, Motions::any);
    expect_same_contacts(world, {.min_separation = 0.02});
  }
}

/// The random worlds again, of bodies that are thick, some more than others.
TEST(World, AgreesWithRadii) {
  std::size_t contacts = 0, near = 0;
  for (std::uint64_t seed = 200; seed < 212; ++seed) {
    SCOPED_TRACE(seed);
    TestWorld world = random_world(seed, 2.5, seed % 2 ? Motions::any : Motions::straight);
    expect_same_contacts(world);  // what is gathered here knows of no radii
    Random random(seed);
    for (BodyId id = 0; place(id) < world.bodies.size(); ++id) world.set_radius(id, 0.03 * random.below(3));
    contacts += expect_same_contacts(world, {.min_separation = 0.01});
    expect_same_first(world);
    OneMesh mesh(world);
    std::span<const NearPair> expected = mesh.detector.pairs_within(mesh.start, 0.02);
    const std::vector<BodyNearPair> found = world.world.pairs_within(0.02);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(named(found[i]), named(expected[i], mesh));
    near += found.size();
    if (seed % 2) continue;
    EXPECT_EQ(world.world.safe_step(0.3).toi_lower, mesh.detector.safe_step(mesh.step(), 0.3).toi_lower);
  }
  EXPECT_GT(contacts, 500u);
  EXPECT_GT(near, 200u);
}

TEST(World, AgreesAboutPairsAtRest) {
  std::size_t pairs = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    TestWorld world = random_world(seed, 1.5, Motions::any);
    OneMesh mesh(world);
    std::span<const NearPair> expected = mesh.detector.pairs_within(mesh.start, 0.1);
    const std::vector<BodyNearPair> found = world.world.pairs_within(0.1);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(named(found[i]), named(expected[i], mesh));
      EXPECT_EQ(found[i].distance, expected[i].distance);
    }
    pairs += found.size();
  }
  EXPECT_GT(pairs, 1000u);
}

TEST(World, AgreesAboutIntersections) {
  std::size_t count = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    TestWorld world = random_world(seed, 1, Motions::any);
    OneMesh mesh(world);
    const auto body = [&](Index v) { return mesh.names[place(v)][0]; };
    const auto own = [&](Index v) { return mesh.names[place(v)][1]; };
    std::set<std::tuple<BodyId, Edge, BodyId, Face>> expected, found;
    for (const Intersection& one : mesh.detector.intersections(mesh.start)) {
      const BodyId of_edge = body(one.edge[0]), of_face = body(one.face[0]);
      const auto motion = [&](BodyId id) -> const BodyMotion& { return world.bodies[place(id)].motion; };
      if (of_edge == of_face && !std::holds_alternative<Deforming>(motion(of_edge))) continue;
      if (std::holds_alternative<Static>(motion(of_edge)) && std::holds_alternative<Static>(motion(of_face))) continue;
      expected.insert({of_edge,
                       {own(one.edge[0]), own(one.edge[1])},
                       of_face,
                       {own(one.face[0]), own(one.face[1]), own(one.face[2])}});
    }
    for (const BodyIntersection& one : world.world.intersections())
      found.insert({one.bodies[0], one.edge, one.bodies[1], one.face});
    EXPECT_EQ(found, expected);
    EXPECT_EQ(world.world.has_intersection(), !expected.empty());
    count += found.size();
  }
  EXPECT_GT(count, 100u);
}

TEST(World, AgreesAboutHowFarTheStepMayGo) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (const double fraction : {0.0, 0.1, 0.5}) {
      SCOPED_TRACE(seed);
      TestWorld world = random_world(seed, 6, Motions::straight);
      OneMesh mesh(world);
      const SafeStep expected = mesh.detector.safe_step(mesh.step(), fraction);
      const BodyStep found = world.world.safe_step(fraction);
      EXPECT_EQ(found.toi_lower, expected.toi_lower);
      ASSERT_EQ(found.pair.has_value(), expected.pair.has_value());
      if (found.pair) {
        EXPECT_EQ(named(*found.pair), named(*expected.pair, mesh));
      }
    }
  }
}

/// Where all are at one time of their path.
std::vector<Point> points_at(const RigidPath& path, double time) {
  std::vector<Index> all;
  for (Index v = 0; v < path.vertex_count(); ++v) all.push_back(v);
  std::vector<Point> points(all.size());
  std::vector<double> errors(all.size());
  path.points_at(time, all, points, errors);
  return points;
}

/// Samples of the way: until the step's end each pair keeps its part, and there the one that ends it has no more.
TEST(World, KeepsDistancesWhereBodiesTurn) {
  constexpr double kRounding = 1e-12, kSample = 0.4;
  int ended = 0, whole = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    for (const auto& [part, gap] : {std::pair{0.0, 0.0}, {0.1, 0.0}, {0.3, 0.02}}) {
      const double keep = part, separation = gap;
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", keep " << keep);
      TestWorld world = random_world(seed, 6, Motions::any);
      OneMesh mesh(world);
      const BodyStep step = world.world.safe_step(keep, {.min_separation = separation});
      const auto kept = [&](const NearPair& pair) {
        const double start = distance_of({pair.kind, pair.vertices}, mesh.start).distance;
        return separation + keep * std::max(start - separation, 0.0);
      };
      for (int sample = 1; step.toi_lower > 0 && sample <= 8; ++sample) {
        const std::vector<Point> points = points_at(mesh.path, step.toi_lower * sample / 8);
        for (const NearPair& near : mesh.detector.pairs_within(points, kSample))
          ASSERT_GE(near.distance, kept(near) - kRounding) << sample;
      }
      EXPECT_EQ(step.pair.has_value(), step.toi_lower < 1);
      if (!step.pair) {
        ++whole;
        continue;
      }
      ++ended;
      EXPECT_NEAR(step.toi_upper, step.toi_lower, 1e-8);
      const std::vector<Point> end = points_at(mesh.path, step.toi_upper);
      double excess = 1;
      for (const NearPair& near : mesh.detector.pairs_within(end, 6))
        if (named(near, mesh) == named(*step.pair)) excess = near.distance - kept(near);
      EXPECT_LE(excess, 1e-7);
    }
  }
  EXPECT_GT(ended, 5);
  EXPECT_GT(whole, 0);
}

/// The tip of a rod of length 2 goes down to a floor below it, on an arc.
TEST(World, KnowsHowFarARodMayTurn) {
  const Shape rod(Mesh(2, {}, {{0, 1}}), {{0, 0, 0}, {2, 0, 0}});
  const Shape ground(Mesh(3, {{0, 1, 2}}), {{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}});
  World world(one_thread());
  world.add(ground, Static{{{0, 0, -1}, {}}});
  world.add(rod, Rigid{interpolated_chain({}, {{}, {0, 1, 0}})});
  for (const double keep : {0.0, 0.1, 0.5}) {
    const BodyStep step = world.safe_step(keep);
    EXPECT_NEAR(step.toi_lower, std::asin((1 - keep) / 2), 1e-8);
    EXPECT_NEAR(step.toi_upper, step.toi_lower, 1e-8);
    ASSERT_TRUE(step.pair);
    EXPECT_NEAR(step.pair->distance, 1, 1e-14);
  }
}

}  // namespace
}  // namespace tamis::test

// Motions and places that are hard: many turns, a thread in a thread, far from the origin, at the ends of doubles.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "tamis/error.hpp"
#include "tamis/pair_distance.hpp"
#include "worlds/oracle_world.hpp"
#include "worlds/simple_shapes.hpp"

namespace tamis::test {
namespace {

/// A bar that turns by many turns, between two posts that it meets as soon as it is a little beyond.
TEST(World, FollowsHugeRotations) {
  const Shape bar(Mesh(3, {{0, 1, 2}}), {{-2, 0, 0}, {2, 0, 0}, {0, 0, 0.1}});
  const Shape post(Mesh(2, {}, {{0, 1}}), {{0, 0, -1}, {0, 0, 1}});
  for (const double turns : {0.25, 1.0, 20.0}) {
    World world;
    const double angle = 2 * std::numbers::pi * turns;
    world.add(bar, Rigid{interpolated_chain({}, {{}, {0, 0, angle}})});
    world.add(post, Static{{{1, 1, 0}, {}}});
    EXPECT_NEAR(world.earliest().toi_lower, std::numbers::pi / 4 / angle, 1e-8);
    EXPECT_FALSE(world.contacts().empty());
  }
}

/// So far that the step has kMostPieces pieces, each of which bends by more than one should. The bar comes nearer to a
/// post, turning, and meets it within half a turn of when it can.
TEST(World, FollowsRotationsBeyondItsPieces) {
  constexpr double kTurns = 650;
  const Shape bar(Mesh(2, {}, {{0, 1}}), {{-2, 0, 0}, {2, 0, 0}});
  const Shape post(Mesh(2, {}, {{0, 1}}), {{0, 0, -1}, {0, 0, 1}});
  World world(one_thread());
  world.add(bar, Rigid{interpolated_chain({}, {{2, 0, 0}, {0, 0, 2 * std::numbers::pi * kTurns}})});
  world.add(post, Static{{{3.1, 0.2, 0}, {}}});
  const double reached = (3.1 - std::sqrt(4 - 0.2 * 0.2)) / 2;  // by the disc in which the bar turns
  const EarliestBodyContact first = world.earliest();
  EXPECT_GE(first.toi_upper, reached);
  EXPECT_LE(first.toi_lower, reached + 0.5 / kTurns);
  EXPECT_LE(first.toi_upper, first.toi_lower + 1e-8);
}

/// A nut that follows the thread of a bolt is free, however far it turns; one that goes too far up for its turn meets
/// it when the oracle of turning pairs says so, of all pairs.
TEST(World, TurnsANutOnABolt) {
  const scenes::Thread thread{2, 12, 2, 1, 0.6, 0.3};
  scenes::Thread larger = thread;
  larger.turns = 1;
  larger.radius += 0.08;
  const auto shape_of = [](const scenes::Shape& s) {
    return Shape({static_cast<Index>(s.points.size()), s.faces}, s.points);
  };
  const Shape bolt = shape_of(scenes::thread(thread)), nut = shape_of(scenes::thread(larger));
  World world(one_thread());
  const BodyId still = world.add(bolt, Static{}), turning = world.add(nut, Static{});
  const Pose start{{0, 0, 0.3}, {0, 0, std::numbers::pi}};
  const auto turned = [&](double angle, double up) {
    return Pose{{0, 0, start.position[2] + 0.6 * angle / (2 * std::numbers::pi) + up},
                {0, 0, std::numbers::pi + angle}};
  };
  for (const double angle : {0.1, 1.0, 3.0}) {
    world.move(turning, Rigid{interpolated_chain(start, turned(angle, 0))});
    EXPECT_TRUE(world.is_free()) << angle;
    const Pose end = turned(angle, 0.15);
    world.move(turning, Rigid{interpolated_chain(start, end)});
    const auto first = static_cast<double>(
        oracle::first_touch(for_oracle(bolt, Static{}), for_oracle(nut, Rigid{interpolated_chain(start, end)})));
    const EarliestBodyContact found = world.earliest();
    ASSERT_TRUE(found.contact) << angle;
    EXPECT_EQ(std::set<BodyId>(found.contact->bodies.begin(), found.contact->bodies.end()),
              (std::set<BodyId>{still, turning}));
    EXPECT_LE(found.toi_lower, first + 1e-12) << angle;
    EXPECT_GE(found.toi_upper, first - 1e-12) << angle;
    EXPECT_GT(found.toi_lower, first - 1e-6) << angle;
  }
}

TEST(World, IsAsExactFarFromTheOrigin) {
  const Point far{1e8, -3e8, 2e8};
  World world;
  const auto at = [&](double height) { return Pose{{far[0], far[1], far[2] + height}, {}}; };
  world.add(floor(), Static{at(0)});
  const BodyId cubes = world.add(cube(), Rigid{interpolated_chain(at(1.75), at(0.75))});
  EXPECT_NEAR(world.earliest().toi_lower, 0.75, 1e-12);
  Pose end = at(0.75);
  end.rotation = {0, 0, 1};
  world.move(cubes, Rigid{interpolated_chain(at(1.75), end)});
  EXPECT_NEAR(world.earliest().toi_lower, 0.75, 1e-6);
}

/// Bug: differences of gaps that overflow said when boxes part along one axis.
TEST(World, GoesAsFarAsDoubles) {
  constexpr double kUnit = 1e307;
  const auto plate_at = [](double x, double y, double z) {
    return std::vector<Point>{{x - kUnit, y - kUnit, z}, {x + kUnit, y - kUnit, z}, {x, y + kUnit, z}};
  };
  const Shape plate(Mesh(3, {{0, 1, 2}}), plate_at(0, 0, 0));
  World world(one_thread());
  world.add(plate, Static{});
  const double far = 12 * kUnit, side = 5 * kUnit;
  world.add(plate, Deforming{plate_at(-far, side, side), plate_at(far, -side, -side)});
  EXPECT_NEAR(world.earliest().toi_lower, 0.5, 1e-12);
}

/// Bug: where squares of lengths underflow, the boxes of what turns held its chords alone. A rod sweeps over a post
/// that stands between its arc and the chord.
TEST(World, FollowsArcsAtAnyScale) {
  for (const int exponent : {0, -500, -540, -600, -900}) {
    SCOPED_TRACE(exponent);
    const double unit = std::ldexp(1.0, exponent);
    const Shape rod(Mesh(2, {}, {{0, 1}}), {{0, 0, 0}, {unit, 0, 0}});
    const Shape post(Mesh(2, {}, {{0, 1}}), {{0, 0, -unit}, {0, 0, unit}});
    World world(one_thread());
    world.add(rod, Rigid{interpolated_chain({}, {{}, {0, 0, 0.3}})});
    world.add(post, Static{{{0.9999 * unit * std::cos(0.15), 0.9999 * unit * std::sin(0.15), 0}, {}}});
    EXPECT_NEAR(world.earliest().toi_lower, 0.5, 1e-8);
  }
}

/// A plate at the end of an arm turns as often as it may past another one that stands in its way.
World plate_on_an_arm(double unit) {
  const Shape plate(Mesh(3, {{0, 1, 2}}), {{-unit, -unit, 0}, {unit, -unit, 0}, {0, unit, 0}});
  World world(one_thread());
  const Pose arm{{10 * unit, 0, 0}, {}}, turn{{}, {0, 0, 4096}};
  world.add(plate, Rigid{{{{}, turn}, {arm, arm}}});
  world.add(plate, Static{{{0, 10 * unit, 0}, {0, std::numbers::pi / 2, 0}}});
  return world;
}

/// Bug: boxes of what bends without bound were left out of those that hold them, so that it was free.
TEST(World, FollowsWhatBendsWithoutBoundOrRefusesIt) {
  const EarliestBodyContact first = plate_on_an_arm(1e289).earliest();
  ASSERT_TRUE(first.contact);
  EXPECT_LT(first.toi_lower, 0.5 * std::numbers::pi / 4096);
  EXPECT_THROW((void)plate_on_an_arm(1e301).earliest(), InvalidPath);
}

// Bug: three specks that turned within a separation a million times their size took seconds, cut into thousands of
// pieces.
TEST(World, CutsTurnsNoFinerThanASeparationAsks) {
  constexpr double kSize = 1e-6;
  const Shape speck(Mesh(3, {{0, 1, 2}}), {{0, 0, 0}, {kSize, 0, 0}, {0, kSize, 0}});
  World world({.min_separation = 0.7});
  world.add(speck, Static{{{1, 0, 0.5}, {}}});
  const Pose arm{{1, 0, 0}, {}}, turn{{}, {0, 0, 3}};
  world.add(speck, Rigid{{{{{}, {0, 0, -3}}, turn}, {arm, arm}}});
  EXPECT_FALSE(world.contacts().empty());
  EXPECT_LT(world.statistics().nodes_visited, 1000U);
}

// Bugs: pairs are searched as far as they move in the whole step, so each is decided: n^2; or not as far as they have
// moved until then.
TEST(World, SafeStepsSearchAsFarAsPairsHaveMoved) {
  std::vector<Point> points;
  std::vector<Face> faces;
  constexpr Index kCells = 4;
  for (Index i = 0; i <= kCells; ++i)
    for (Index j = 0; j <= kCells; ++j) {
      points.push_back({double(i) / kCells - 0.5, double(j) / kCells - 0.5, 0});
      const Index v = i * (kCells + 1) + j;
      if (i == kCells || j == kCells) continue;
      faces.push_back({v, v + kCells + 1, v + kCells + 2});
      faces.push_back({v, v + kCells + 2, v + 1});
    }
  const Shape square(Mesh(static_cast<Index>(points.size()), faces), points);
  World world(one_thread());
  world.add(square, Rigid{{{{}, {{0, 0, 0}, {0, 0, 1}}}}});
  world.add(square, Rigid{{{{{1.45, 0, 0.01}, {}}, {{1.45, 0, 0.01}, {0, 0, -1}}}}});
  for (const double keep : {0.1, 0.5, 0.9}) {
    const BodyStep step = world.safe_step(keep);
    ASSERT_TRUE(step.pair.has_value());
    EXPECT_LT(world.statistics().decided_by.scalar, 700u) << keep;
    // The least part of its distance that any two vertices or edges keep, by samples.
    const auto least_kept = [&](double time) {
      double least = 1;
      std::vector<Point> all[2];
      for (std::size_t at = 0; at < 2; ++at)
        for (const BodyId body : {0, 1}) {
          const auto here = world.points_at(body, at == 0 ? 0 : time).points;
          all[at].insert(all[at].end(), here.begin(), here.end());
        }
      const auto count = static_cast<Index>(points.size());
      for (const Edge& a : square.mesh().edges())
        for (const Edge& b : square.mesh().edges()) {
          const FeaturePair pair{PairKind::edge_edge, {a[0], a[1], b[0] + count, b[1] + count}};
          least = std::min(least, distance_of(pair, all[1]).distance / distance_of(pair, all[0]).distance);
        }
      return least;
    };
    for (int i = 0; i < 8; ++i) EXPECT_GE(least_kept(step.toi_lower * i / 8), keep) << keep;
    EXPECT_NEAR(least_kept(step.toi_lower), keep, 1e-5) << keep;
  }
}

}  // namespace
}  // namespace tamis::test

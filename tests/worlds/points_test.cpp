// Where a body's vertices are at a time of its motion, against paths and steps of the same motion.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "tamis/error.hpp"
#include "worlds/simple_shapes.hpp"

namespace tamis::test {
namespace {

const RigidChain kTurn = turned_chain({{1, 2, 3}, {0.1, 0.2, 0.3}}, {2, -1, 5}, {4, 4, 4}, {0.5, 0, 0});

/// Bit for bit what a question about the turn asks, errors too.
TEST(World, TellsWhereVerticesAreOnTheirCurves) {
  World world;
  const Shape shape = cube();
  const BodyId body = world.add(shape, Rigid{kTurn});
  const auto count = static_cast<std::size_t>(shape.mesh().vertex_count());
  const RigidPath path(shape.points(), std::vector<Index>(count, 0), {kTurn});
  std::vector<Index> all(count);
  std::iota(all.begin(), all.end(), 0);
  std::vector<Point> points(count);
  std::vector<double> errors(count);
  for (const double time : {0.0, 0.3, 1.0}) {
    path.points_at(time, all, points, errors);
    const BodyPoints found = world.points_at(body, time);
    EXPECT_EQ(found.points, points);
    EXPECT_EQ(found.error, *std::max_element(errors.begin(), errors.end()));
    EXPECT_LT(found.error, 1e-13);
  }
}

/// At the time at which a bar that turns meets a post, the bar is where the post stands.
TEST(World, TellsWhereAContactIs) {
  World world;
  const Shape bar(Mesh(2, {}, {{0, 1}}), {{0, 0, 0}, {2, 0, 0}}), post(Mesh(2, {}, {{0, 1}}), {{1, 1, -1}, {1, 1, 1}});
  const BodyId turning = world.add(bar, Rigid{interpolated_chain({}, {{}, {0, 0, 3}})}),
               still = world.add(post, Static{});
  const EarliestBodyContact first = world.earliest();
  ASSERT_TRUE(first.contact);
  const Point end = world.points_at(turning, first.toi_lower).points[1];
  EXPECT_NEAR(end[0], std::sqrt(2), 1e-8);
  EXPECT_NEAR(end[1], std::sqrt(2), 1e-8);
  EXPECT_EQ(world.points_at(still, first.toi_lower).points, post.points());
  EXPECT_EQ(world.points_at(still, first.toi_lower).error, 0);
}

/// Of what goes straight the ends are exact, and what no feature has may be anywhere.
TEST(World, TellsWhereVerticesAreThatGoStraight) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Mesh mesh(4, {{0, 1, 2}});
  const std::vector<Point> start{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {nan, 0, 0}};
  std::vector<Point> end = start;
  for (Point& x : end) x[2] = 0.1;
  World world;
  const BodyId soft = world.add({mesh, start}, Deforming{start, end});
  const BodyId rigid = world.add({mesh, start}, Rigid{interpolated_chain({}, {{0, 0, 0.1}, {}})});
  for (const BodyId body : {soft, rigid}) {
    const auto corner = [&](double time) { return world.points_at(body, time).points[1]; };
    EXPECT_EQ(corner(0), start[1]);
    EXPECT_EQ(corner(1), end[1]);
    EXPECT_EQ(world.points_at(body, 1).error, 0);
    const double error = world.points_at(body, 0.3).error;
    EXPECT_GT(error, 0);
    EXPECT_LT(error, 1e-15);
    EXPECT_NEAR(corner(0.3)[2], 0.03, error);
  }
}

TEST(BadWorld, RefusesTimesOutsideTheStep) {
  World world;
  const BodyId body = world.add(cube(), Static{});
  for (const double time : {-0.1, 1.5, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW((void)world.points_at(body, time), InvalidOptions);
  EXPECT_THROW((void)world.points_at(body + 1, 0.5), InvalidOptions);
  world.remove(body);
  EXPECT_THROW((void)world.points_at(body, 0.5), InvalidOptions);
}

}  // namespace
}  // namespace tamis::test

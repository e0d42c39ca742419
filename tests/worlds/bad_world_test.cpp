// What a world refuses, and with which sentence.
#include <gtest/gtest.h>

#include <limits>

#include "tamis/error.hpp"
#include "worlds/random_world.hpp"
#include "worlds/simple_shapes.hpp"

namespace tamis::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Shape triangle() { return {Mesh(3, {{0, 1, 2}}), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}; }

template <class Wrong, class F>
void expect_refused(const F& ask, const std::string& sentence) {
  try {
    ask();
    FAIL() << "not refused: " << sentence;
  } catch (const Wrong& e) {
    EXPECT_EQ(std::string(e.what()), sentence);
  }
}

TEST(BadWorld, NamesBodiesThatThereAreNot) {
  World world;
  const BodyId gone = world.add(triangle(), Static{});
  world.remove(gone);
  const std::string removed = "body 0 has been removed: name one that is still there";
  expect_refused<InvalidOptions>([&] { world.remove(gone); }, removed);
  expect_refused<InvalidOptions>([&] { world.move(gone, Static{}); }, removed);
  expect_refused<InvalidOptions>([&] { (void)world.motion(gone); }, removed);
  expect_refused<InvalidOptions>([&] { world.set_enabled(gone, true); }, removed);
  expect_refused<InvalidOptions>([&] { world.set_radius(gone, 1); }, removed);
  const BodyId there = world.add(triangle(), Static{});
  EXPECT_NE(there, gone);
  expect_refused<InvalidOptions>([&] { world.set_may_touch(there, gone, false); }, removed);
  expect_refused<InvalidOptions>([&] { world.move(2, Static{}); },
                                 "the world has no body 2: give a number that `add` has returned");
  expect_refused<InvalidOptions>([&] { world.move(-1, Static{}); },
                                 "the world has no body -1: give a number that `add` has returned");
}

TEST(BadWorld, RefusesShapesWithoutPoints) {
  expect_refused<InvalidMesh>(
      [] {
        Shape(Mesh(3, {{0, 1, 2}}), {{0, 0, 0}});
      },
      "the shape has 1 points, its mesh 3 vertices: give one point a vertex");
  expect_refused<InvalidMesh>(
      [] {
        Shape(Mesh(3, {{0, 1, 2}}), {{0, 0, 0}, {kNan, 0, 0}, {0, 0, 0}});
      },
      "vertex 1 of the shape is not finite: give finite points");
}

TEST(BadWorld, RefusesMotionsThatAreNone) {
  World world;
  const BodyId body = world.add(triangle(), Static{});
  const std::string pose = "a pose of body 0 is not finite: give finite positions and rotation vectors";
  expect_refused<InvalidStep>([&] { world.move(body, Static{{{kNan, 0, 0}, {}}}); }, pose);
  expect_refused<InvalidStep>([&] { world.move(body, Rigid{interpolated_chain({}, {{}, {0, kNan, 0}})}); }, pose);
  const std::vector<Point> points = triangle().points();
  expect_refused<InvalidStep>(
      [&] {
        world.move(body, Deforming{points, {{0, 0, 0}}});
      },
      "body 0 has 1 points at the end of its motion, its shape 3 vertices: give one point a vertex");
  expect_refused<InvalidStep>(
      [&] {
        world.move(body, Deforming{{{0, 0, 0}, {0, kNan, 0}, {0, 0, 0}}, points});
      },
      "vertex 1 of body 0 at the start of its motion is not finite: give finite points");
  expect_refused<InvalidStep>(
      [&] {
        world.add(triangle(), Static{{{kNan, 0, 0}, {}}});
      },
      "a pose of body 1 is not finite: give finite positions and rotation vectors");
  EXPECT_EQ(world.add(triangle(), Static{}), 1);  // what was refused has no number
  EXPECT_TRUE(world.is_free());
}

/// Bug: such a body was taken, and each question after it was refused for "vertex 3 of the path", which is one of a
/// mesh that the caller has never seen.
TEST(BadWorld, RefusesMotionsBeyondDoublesByTheBody) {
  const Shape large(Mesh(3, {{0, 1, 2}}), {{1e308, 0, 0}, {0, 0, 0}, {0, 1, 0}});
  World world;
  world.add(triangle(), Rigid{interpolated_chain({}, {{0, 0, 1}, {0, 0, 1}})});
  const BodyId body = world.add(large, Static{{{-1e308, 0, 0}, {}}});
  const auto beyond = [](const std::string& vertex, const std::string& when) {
    return "where vertex " + vertex + " of body 1 is at the " + when +
           " of its motion is beyond what doubles hold: give shorter positions";
  };
  const Pose far{{1e308, 0, 0}, {}};
  expect_refused<InvalidStep>([&] { world.move(body, Static{far}); }, beyond("0", "start"));
  expect_refused<InvalidStep>([&] { world.move(body, Rigid{interpolated_chain({}, far)}); }, beyond("0", "end"));
  const Pose arm{{1.5e308, 0, 0}, {}}, back{{-1.5e308, 0, 0}, {}}, turn{{}, {0, 0, 0.1}};
  expect_refused<InvalidStep>(
      [&] {
        world.move(body, Rigid{{{{}, turn}, {arm, arm}, {back, back}}});
      },
      "body 1 turns about a point that is farther away than doubles hold: give shorter positions");
  const std::vector<BodyMotion> motions{Static{far}};
  expect_refused<InvalidStep>([&] { (void)world.earliest_many(std::array{body}, motions); },
                              "motion 0: " + beyond("0", "start"));
  EXPECT_EQ(std::get<Static>(world.motion(body)).pose.position[0], -1e308);
  expect_refused<InvalidPath>([&] { (void)world.is_free(); },
                              "body 1 goes farther than doubles can follow beside bodies that turn: give shorter "
                              "positions");
  world.remove(body);
  EXPECT_TRUE(world.is_free());
}

/// Bug: a question about such a body took longer than anyone waits, and a pose of 1e17 radians, which stand 16 apart,
/// was taken as if somebody meant it.
TEST(BadWorld, RefusesTurnsThatNobodyWaitsForOrMeans) {
  World world;
  const BodyId body = world.add(triangle(), Static{});
  const auto turn = [](double x, double y, double z) { return Pose{{}, {x, y, z}}; };
  const auto turns = [](const std::string& radians) {
    return "body 0 turns by " + radians + " radians in one step, beyond 4096: query parts of the step";
  };
  expect_refused<InvalidStep>([&] { world.move(body, Rigid{interpolated_chain({}, turn(0, 0, 4097))}); },
                              turns("4097"));
  expect_refused<InvalidStep>([&] { world.move(body, Rigid{turned_chain({}, {3000, 0, 4000}, {})}); }, turns("5000"));
  const RigidLink half{{}, turn(0, 3000, 0)};
  expect_refused<InvalidStep>([&] { world.move(body, Rigid{{half, half}}); }, turns("6000"));
  const auto is_long = [](const std::string& radians) {
    return "a rotation vector of body 0 is " + radians +
           " radians long, beyond 2^32: take whole turns off it, as doubles have no finer angles there";
  };
  expect_refused<InvalidStep>([&] { world.move(body, Static{turn(0, 1e17, 0)}); }, is_long("1e+17"));
  expect_refused<InvalidStep>(
      [&] { world.move(body, Rigid{interpolated_chain(turn(6e9, 0, 8e9), turn(6e9, 0, 8e9))}); }, is_long("1e+10"));
  const std::vector<BodyMotion> motions{Static{}, Rigid{interpolated_chain({}, turn(0, -5000, 0))}};
  expect_refused<InvalidStep>([&] { (void)world.earliest_many(std::array{body}, motions); },
                              "motion 1: " + turns("5000"));
  world.move(body, Static{turn(0, 0, 0x1p32)});
  world.move(body, Rigid{interpolated_chain(turn(0, 0, 1e9), turn(0, 0, 1e9 - 4096))});
  world.move(body, Rigid{{{turn(0, 0, 1e9), turn(0, 0, 1e9)}, half}});
}

/// Bug: the hierarchies of shapes and bodies were made with the best instruction set, whatever was asked for.
TEST(BadWorld, RefusesInstructionSetsThatAreNone) {
  Options options;
  options.isa = static_cast<Isa>(9);
  const std::string sentence = "unknown instruction set number 9: use one of the enumeration's names";
  expect_refused<InvalidOptions>([&] { World world(options); }, sentence);
  const Mesh mesh(3, {{0, 1, 2}});
  const std::vector<Point> points = triangle().points();
  expect_refused<InvalidOptions>([&] { Shape(mesh, points, options.isa); }, sentence);
  for (const Isa isa : {Isa::best, Isa::baseline}) EXPECT_EQ(Shape(mesh, points, isa).points(), points);
}

TEST(BadWorld, RefusesOptionsOfOneMesh) {
  Options groups;
  groups.filter = PairFilter::no_self_contact({0, 0, 0});
  expect_refused<InvalidOptions>([&] { World world(groups); },
                                 "the options of a world have groups or a function that accepts pairs, which are about "
                                 "one mesh: say which bodies may touch by set_may_touch");
  Options negative;
  negative.threads = -1;
  EXPECT_THROW(World{negative}, InvalidOptions);
  Options thick;
  thick.radii = {0.1};
  expect_refused<InvalidOptions>([&] { World world(thick); },
                                 "the options of a world have radii, which are one a group of one mesh: give each body "
                                 "its own by set_radius");
  World world;
  const BodyId body = world.add(triangle(), Static{});
  EXPECT_THROW(world.set_radius(body, -1), InvalidOptions);
  EXPECT_THROW(world.set_radius(body, kNan), InvalidOptions);
  EXPECT_THROW((void)world.contacts({.min_separation = -1}), InvalidOptions);
  EXPECT_THROW((void)world.earliest({.tolerance = 0}), InvalidOptions);
  EXPECT_THROW((void)world.pairs_within(kNan), InvalidOptions);
  EXPECT_THROW((void)world.safe_step(1), InvalidOptions);
  world.set_radius(body, 1.7e308);
  world.set_radius(world.add(triangle(), Rigid{}), 1.7e308);
  EXPECT_THROW((void)world.contacts(), InvalidOptions);
  EXPECT_THROW((void)world.pairs_within(0), InvalidOptions);
}

TEST(BadWorld, RefusesWhatCannotTouch) {
  World world;
  world.add(triangle(), Static{});
  world.add(triangle(), Static{});
  expect_refused<InvalidOptions>([&] { world.set_may_touch(0, 0, true); },
                                 "body 0 does not deform, so it cannot touch itself: leave that out");
}

TEST(BadWorld, FailsForWhatTouchesAtTheStart) {
  World world;
  world.add(triangle(), Static{});
  const BodyId moving = world.add(triangle(), Rigid{interpolated_chain({{0, 0, 0.1}, {}}, {{0, 0, 1}, {}})});
  const PathOptions fail{.min_separation = 0.2, .at_start = AtStart::fail};
  const std::string sentence =
      "vertex 0 and face 0 1 2 of bodies 0 and 1 touch at the start, or are nearer than can be told: move them apart, "
      "keep the bodies apart by set_may_touch, or pass at_start ignore";
  expect_refused<InvalidStep>([&] { (void)world.contacts(fail); }, sentence);
  expect_refused<InvalidStep>([&] { (void)world.earliest(fail); }, sentence);
  expect_refused<InvalidStep>([&] { (void)world.is_free(fail); }, sentence);
  expect_refused<InvalidStep>([&] { (void)world.safe_step(0.1, fail); }, sentence);
  world.move(moving, Rigid{interpolated_chain({{0, 0, 0.1}, {}}, {{0, 0, 1}, {0, 0, 1}})});
  expect_refused<InvalidStep>([&] { (void)world.contacts(fail); }, sentence);
  expect_refused<InvalidStep>([&] { (void)world.is_free(fail); }, sentence);
  EXPECT_TRUE(world.is_free({.min_separation = 0.05, .at_start = AtStart::fail}));
  expect_refused<InvalidStep>([&] { (void)world.safe_step(0.1, fail); }, sentence);
}

TEST(BadWorld, RefusesOneThatHasBeenMovedFrom) {
  World world;
  const World other(std::move(world));
  EXPECT_THROW((void)world.contacts(), Error);
  EXPECT_THROW(world.add(triangle(), Static{}), Error);
}

/// Bug: a shape that was moved from had no mesh, and a body of it was an access to nothing.
TEST(World, TakesAShapeThatHasBeenMovedFrom) {
  Shape shape = triangle();
  const Shape other(std::move(shape));  // NOLINT(performance-move-const-arg): that it is a copy is what is tested
  World world;
  world.add(shape, Static{});
  world.add(other, Rigid{});
  EXPECT_FALSE(world.is_free());
  EXPECT_EQ(&shape.mesh(), &other.mesh());
}

/// All or none: what is refused changes no body.
TEST(BadWorld, ManyBodiesAreChangedOrNone) {
  const Shape body = cube();
  World world;
  const std::vector<BodyId> both = world.add_many(body, {Static{}, Rigid{interpolated_chain({}, {{1, 0, 0}, {}})}});
  EXPECT_EQ(both, (std::vector<BodyId>{0, 1}));
  const Deforming too_few{{{0, 0, 0}}, {{0, 0, 0}}};
  EXPECT_THROW(world.add_many(body, {Static{}, too_few}), InvalidStep);
  EXPECT_THROW(world.move_many(both, {Rigid{}, too_few}), InvalidStep);
  EXPECT_THROW(world.move_many(both, {Rigid{}}), InvalidOptions);
  EXPECT_THROW(world.move_many(std::vector<BodyId>{0, 0}, {Rigid{}, Rigid{}}), InvalidOptions);
  EXPECT_THROW(world.move_many(std::vector<BodyId>{0, 7}, {Rigid{}, Rigid{}}), InvalidOptions);
  EXPECT_EQ(world.motion(0).index(), 0U);
  const std::vector<std::array<BodyId, 2>> pairs{{0, 1}, {0, 7}};
  EXPECT_THROW(world.set_may_touch(pairs, false), InvalidOptions);
  EXPECT_FALSE(world.contacts().empty());
  world.move_many(both, {Rigid{interpolated_chain({}, {{1, 0, 0}, {}})}, Static{{{9, 0, 0}, {}}}});
  EXPECT_EQ(world.motion(0).index(), 1U);
  EXPECT_EQ(world.add(body, Static{}), 2);
}

}  // namespace
}  // namespace tamis::test

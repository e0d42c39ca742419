// Bodies inside one another: they touch nothing, and count as overlapping.
#include <gtest/gtest.h>

#include <cmath>

#include "oracle/oracle.hpp"
#include "oracle/winding.hpp"
#include "support/threads.hpp"
#include "tamis/error.hpp"
#include "worlds/random_world.hpp"
#include "worlds/simple_shapes.hpp"

namespace tamis::test {
namespace {

scenes::Shape scaled(scenes::Shape shape, double by, const Point& to = {0, 0, 0}) {
  for (Point& p : shape.points)
    for (std::size_t k = 0; k < 3; ++k) p[k] = by * p[k] + to[k];
  return shape;
}
scenes::Shape reversed(scenes::Shape shape) {
  for (Face& face : shape.faces) std::swap(face[0], face[1]);
  return shape;
}
/// Both in one mesh.
scenes::Shape joined(scenes::Shape a, const scenes::Shape& b) {
  const auto first = static_cast<Index>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const Face& f : b.faces) a.faces.push_back({first + f[0], first + f[1], first + f[2]});
  return a;
}
Shape made(const scenes::Shape& shape) {
  return {Mesh(static_cast<Index>(shape.points.size()), shape.faces), shape.points};
}
scenes::Shape ball(double radius, const Point& center = {0, 0, 0}) {
  return scaled(scenes::unit_sphere(3), radius, center);
}
/// About the z axis, of `around` by `across` cells.
scenes::Shape torus(double radius, double thickness, Index around = 16, Index across = 8) {
  scenes::Shape torus;
  for (Index i = 0; i < around; ++i)
    for (Index j = 0; j < across; ++j) {
      const double turn = 6.283185307179586 * i / around, tilt = 6.283185307179586 * j / across;
      const double out = radius + thickness * std::cos(tilt);
      torus.points.push_back({out * std::cos(turn), out * std::sin(turn), thickness * std::sin(tilt)});
      const Index a = i * across + j, b = i * across + (j + 1) % across;
      const Index c = (i + 1) % around * across + j, d = (i + 1) % around * across + (j + 1) % across;
      torus.faces.push_back({a, c, b});
      torus.faces.push_back({c, d, b});
    }
  return torus;
}

/// At rest but not static, so it takes part in questions about a pose.
Rigid still(const Pose& pose = {}) { return {interpolated_chain(pose, pose)}; }

bool overlap(const Shape& a, const Shape& b, const BodyMotion& how_a = Static{}, const BodyMotion& how_b = still()) {
  World world(one_thread()), other(one_thread());
  world.add(a, how_a);
  world.add(b, how_b);
  other.add(b, how_b);
  other.add(a, how_a);
  const bool found = world.has_overlap();
  EXPECT_EQ(other.has_overlap(), found) << "another order of bodies";
  EXPECT_EQ(world.has_overlap(), found) << "asked again";
  return found;
}
bool overlap(const scenes::Shape& a, const scenes::Shape& b) { return overlap(made(a), made(b)); }

TEST(Overlap, IsABallInABall) {
  World world(one_thread());
  world.add(made(ball(1)), Static{});
  const BodyId inner = world.add(made(ball(0.25)), Rigid{interpolated_chain({}, {{0.25, 0, 0}, {}})});
  EXPECT_TRUE(world.is_free());
  EXPECT_FALSE(world.has_intersection());
  EXPECT_TRUE(world.has_overlap());
  world.move(inner, still({{1.5, 0, 0}, {}}));
  EXPECT_FALSE(world.has_overlap());
  world.move(inner, Static{});
  EXPECT_FALSE(world.has_overlap());
  EXPECT_TRUE(world.has_overlap({.include_static = true}));
  world.set_may_touch(0, inner, false);
  EXPECT_FALSE(world.has_overlap({.include_static = true}));
  world.set_may_touch(0, inner, true);
  world.set_enabled(0, false);
  EXPECT_FALSE(world.has_overlap({.include_static = true}));
}

TEST(Overlap, IsNotWithoutBodies) {
  World world;
  EXPECT_FALSE(world.has_overlap());
  EXPECT_THROW((void)world.is_closed(0), InvalidOptions);
}

TEST(Overlap, IsTouchingFromInside) {
  EXPECT_TRUE(overlap(scenes::unit_cube(1), scaled(scenes::unit_cube(1), 0.5, {0.5, 0, 0})));
  EXPECT_TRUE(overlap(scenes::unit_cube(1), scenes::unit_cube(1)));
}

TEST(Overlap, IsNotInTheHoleOfATorus) {
  EXPECT_FALSE(overlap(torus(3, 1), ball(0.5)));
  EXPECT_TRUE(overlap(torus(3, 1), ball(0.25, {3, 0, 0})));
  EXPECT_TRUE(overlap(torus(3, 1), ball(0.25, {0, -3, 0})));
  EXPECT_FALSE(overlap(torus(3, 1), ball(0.25, {0, 3, 1.5})));
  EXPECT_FALSE(overlap(torus(3, 1), ball(0.25, {5, 0, 0})));
  EXPECT_TRUE(overlap(torus(3, 1), torus(3, 0.25)));
}

TEST(Overlap, OpenMeshesContainNothing) {
  scenes::Shape open = ball(1);
  open.faces.pop_back();
  EXPECT_FALSE(overlap(open, ball(0.25)));
  EXPECT_TRUE(overlap(ball(2), open));  // what is open may be contained
  World world(one_thread());
  const BodyId closed = world.add(made(ball(1)), Static{}), not_closed = world.add(made(open), Static{});
  const BodyId rod = world.add({Mesh(2, {}, {{0, 1}}), {{0, 0, 0}, {0.1, 0, 0}}}, Static{});
  const BodyId partly = world.add(made(joined(open, ball(1, {3, 0, 0}))), still());
  EXPECT_TRUE(world.is_closed(closed));
  EXPECT_FALSE(world.is_closed(not_closed));
  EXPECT_FALSE(world.is_closed(rod));
  EXPECT_FALSE(world.is_closed(partly));
  EXPECT_FALSE(overlap(joined(open, ball(1, {3, 0, 0})), ball(0.25)));
  EXPECT_TRUE(overlap(joined(open, ball(1, {3, 0, 0})), ball(0.25, {3, 0, 0})));
}

// Bug: vertices that only happen to be at one place make one part of two, which is open if one of them is, or is open
// once they part.
TEST(Overlap, IsOfAClosedPartWhateverIsAtItsVertices) {
  scenes::Shape flag;
  flag.points = {{1, 1, 1}, {1, 1, -1}, {2, 2, 2}};
  flag.faces = {{0, 1, 2}};
  EXPECT_TRUE(overlap(joined(scenes::unit_cube(1), flag), ball(0.5)));
  EXPECT_FALSE(overlap(joined(scenes::unit_cube(1), flag), ball(0.1, {1.5, 1.5, 3})));

  scenes::Shape two = joined(scenes::unit_cube(1), scaled(scenes::unit_cube(1), 1, {2, 0, 0}));
  const Shape shape = made(two);
  for (std::size_t i = two.points.size() / 2; i < two.points.size(); ++i) two.points[i][0] += 0.5;
  World world;
  EXPECT_TRUE(world.is_closed(world.add(shape, Deforming{two.points, two.points})));
  EXPECT_TRUE(overlap(shape, made(ball(0.5)), Deforming{two.points, two.points}));
}

TEST(Overlap, PartsWithReversedFacesAreCavities) {
  const scenes::Shape shell = joined(ball(2), reversed(ball(1)));
  EXPECT_FALSE(overlap(shell, ball(0.5)));
  EXPECT_TRUE(overlap(shell, ball(0.2, {1.5, 0, 0})));
  EXPECT_FALSE(overlap(reversed(shell), ball(0.5)));
  EXPECT_TRUE(overlap(reversed(shell), ball(0.2, {1.5, 0, 0})));
  EXPECT_TRUE(overlap(joined(ball(2), ball(1)), ball(0.5)));  // a solid in a solid
  const scenes::Shape both = joined(scenes::unit_cube(1), scaled(scenes::unit_cube(1), 1, {1, 0.25, 0.25}));
  EXPECT_TRUE(overlap(both, ball(0.1, {0.5, 0.5, 0.5})));  // bug: parity would call it outside
}

TEST(Overlap, FacesMayGoAroundInAnyDirection) {
  scenes::Shape mixed = ball(1);
  for (std::size_t i = 0; i < mixed.faces.size(); i += 3) std::swap(mixed.faces[i][0], mixed.faces[i][1]);
  EXPECT_TRUE(overlap(mixed, ball(0.25)));
  EXPECT_FALSE(overlap(mixed, ball(0.25, {1.5, 0, 0})));
  EXPECT_TRUE(overlap(joined(mixed, ball(0.5, {3, 0, 0})), ball(0.25, {3, 0, 0})));
}

TEST(Overlap, SplitVerticesAreOne) {
  scenes::Shape split;  // as files with a normal for each corner
  for (const Face& face : ball(1).faces) {
    const auto first = static_cast<Index>(split.points.size());
    for (const Index v : face) split.points.push_back(ball(1).points[place(v)]);
    split.faces.push_back({first, first + 1, first + 2});
  }
  split.faces.push_back({0, 0, 1});
  const Shape shape = made(split), inner = made(ball(0.25));
  EXPECT_TRUE(overlap(shape, inner));
  EXPECT_TRUE(overlap(shape, inner, still({{1, 2, 3}, {0.5, 1, 2}}), still({{1, 2, 3}, {}})));
  std::vector<Point> torn = split.points;
  torn[0][0] += 1;
  World world;
  EXPECT_TRUE(world.is_closed(world.add(shape, Deforming{split.points, split.points})));
  EXPECT_FALSE(world.is_closed(world.add(shape, Deforming{torn, torn})));
}

TEST(Overlap, KnowsEachOfManyParts) {
  scenes::Shape many = ball(0.1, {9, 0, 0});
  for (int i = 0; i < 40; ++i) many = joined(many, ball(0.1, {9, 0, 1.0 + i}));
  EXPECT_FALSE(overlap(ball(1), many));
  EXPECT_TRUE(overlap(ball(1), joined(many, ball(0.1))));
  EXPECT_TRUE(overlap(many, ball(0.01, {9, 0, 7})));
}

TEST(Overlap, CountsAllKindsOfMotion) {
  const Shape outer = made(ball(1)), inner = made(ball(0.25));
  const Rigid turns{turned_chain({{5, 5, 5}, {1, 2, 3}}, {0, 0, 1}, {9, 5, 5})};
  EXPECT_TRUE(overlap(outer, inner, turns, still({{5, 5, 5}, {0, 1, 0}})));
  EXPECT_FALSE(overlap(outer, inner, turns, still({{9, 5, 5}, {}})));  // only where it starts
  std::vector<Point> start = inner.points(), end = start;
  for (Point& p : end) p[0] += 5;
  EXPECT_TRUE(overlap(outer, inner, Static{}, Deforming{start, end}));
  EXPECT_FALSE(overlap(outer, inner, Static{}, Deforming{end, start}));
}

/// Points and surfaces on a small grid: most rays meet edges and vertices, faces collapse, surfaces pass through
/// themselves. Coordinates are multiples of `unit`. Without orientation, of one connected part.
void expect_oracle(std::uint64_t seed, double unit, bool is_oriented) {
  Random random(seed);
  scenes::Shape surface = scenes::unit_cube(2);
  if (is_oriented && seed % 2 == 0) surface = joined(scenes::unit_cube(1), scenes::unit_cube(1));
  const auto on_grid = [&](int half) -> Point {
    return {unit * (random.below(2 * half + 1) - half), unit * (random.below(2 * half + 1) - half),
            unit * (random.below(2 * half + 1) - half)};
  };
  for (Point& p : surface.points) p = on_grid(3);
  if (!is_oriented) {
    Face& face = surface.faces[1];
    const auto at = [&](std::size_t i) { return surface.points[place(face[i])]; };
    if (at(0) == at(1) || at(1) == at(2) || at(2) == at(0)) return;  // it encloses nothing either way
    std::swap(face[0], face[1]);
  }
  const Shape shape = made(surface);
  World world(one_thread());
  ASSERT_TRUE(world.is_closed(world.add(shape, Static{})));  // also where vertices come to one place
  const BodyId grain = world.add({Mesh(1, {}, {}, {0}), {{0, 0, 0}}}, Static{});
  for (int i = 0; i < 40; ++i) {
    const Point p = on_grid(4);
    world.move(grain, still({p, {}}));
    bool is_on = false;
    for (const Face& f : surface.faces) {
      const std::array<Point, 4> at{p, surface.points[place(f[0])], surface.points[place(f[1])],
                                    surface.points[place(f[2])]};
      is_on = is_on || oracle::touches(PairKind::vertex_face, {at, at});
    }
    if (is_on) continue;
    const oracle::Crossings truth = oracle::crossings(p, surface.points, surface.faces);
    const bool is_inside = is_oriented ? truth.winding != 0 : truth.count % 2 != 0;
    EXPECT_EQ(world.has_overlap(), is_inside) << seed << ' ' << i;
  }
}

TEST(Overlap, AgreesWithTheOracle) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    expect_oracle(seed, 1, true);
    expect_oracle(seed, 0.1, true);
    expect_oracle(seed, 0x1p-1074, true);
    expect_oracle(seed, 0x1p1000, true);
    expect_oracle(seed, 1, false);
  }
}

/// A grain on the surface is within the closed body.
TEST(Overlap, IsAPointOnTheSurface) {
  const Shape grain(Mesh(1, {}, {}, {0}), {{0, 0, 0}});
  for (const Point& p : {Point{1, 0, 0}, {1, 1, 1}, {-1, 0.5, 1}, {0.25, -1, -0.5}, {1, 1, 0}})
    EXPECT_TRUE(overlap(cube(), grain, Static{}, still({p, {}})));
  for (const Point& p : {Point{1 + 0x1p-52, 0, 0}, {1, 1 + 0x1p-52, 1}, {-1, 0.5, -1 - 0x1p-52}})
    EXPECT_FALSE(overlap(cube(), grain, Static{}, still({p, {}})));
}

// Bug: one pair of bodies with many parts takes long, and cannot be cancelled.
TEST(Overlap, CanBeCancelledWithinAPairOfBodies) {
  constexpr Index kGrains = 1000;
  std::vector<Index> grains(place(kGrains));
  for (Index i = 0; i < kGrains; ++i) grains[place(i)] = i;
  int looks = 0;
  Options options = one_thread();
  options.is_cancelled = [&] { return ++looks == kGrains / 2; };
  World world(options);
  world.add(made(torus(3, 1)), Static{});
  world.add({Mesh(kGrains, {}, {}, grains), std::vector<Point>(place(kGrains))}, still());
  EXPECT_THROW((void)world.has_overlap(), Cancelled);
  EXPECT_FALSE(world.has_overlap());
}

/// Small balls at random places in and around a large one.
World grains_around_a_ball(std::uint64_t seed, const Options& options) {
  Random random(seed);
  World world(options);
  world.add(made(ball(1)), Static{});
  for (int i = 0; i < 4; ++i) {
    const Point place = random.point(2);
    world.add(made(ball(0.05)), still({place, {}}));
  }
  return world;
}

TEST(Overlap, DoesNotDependOnThreads) {
  int inside = 0, outside = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Options three = one_thread();
    three.threads = 3;
    const AllowedThreads allowed(3);
    TestWorld any = random_world(seed, 4, Motions::any), any_shared = random_world(seed, 4, Motions::any, three);
    EXPECT_EQ(any_shared.world.has_overlap(), any.world.has_overlap());
    World one = grains_around_a_ball(seed, one_thread()), shared = grains_around_a_ball(seed, three);
    const bool found = one.has_overlap(), crosses = one.has_intersection();
    EXPECT_EQ(shared.has_overlap(), found);
    EXPECT_TRUE(found || !crosses);
    inside += found && !crosses ? 1 : 0;
    outside += found ? 0 : 1;
  }
  EXPECT_GT(inside, 0);
  EXPECT_GT(outside, 0);
}

}  // namespace
}  // namespace tamis::test

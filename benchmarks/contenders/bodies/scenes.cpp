#include <algorithm>
#include <cmath>
#include <numbers>

#include "benchmarks/contenders/bodies/bodies.hpp"
#include "scenes/random.hpp"
#include "tamis/rigid_path.hpp"

namespace tamis::bench {
namespace {

using scenes::Random;

Point direction(Random& random) {
  const double z = random.between(-1, 1), angle = random.between(0, 2 * std::numbers::pi), r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

Point scaled(const Point& p, double by) { return {by * p[0], by * p[1], by * p[2]}; }

void stretch(scenes::Shape& shape, const Point& by) {
  for (Point& p : shape.points)
    for (std::size_t k = 0; k < 3; ++k) p[k] *= by[k];
}

/// Rings of `sectors` corners about the z axis, at heights in [-1, 1] and at the distance radius(height, angle).
template <class Radius>
scenes::Shape revolved(Index rings, Index sectors, const Radius& radius) {
  scenes::Shape shape;
  for (Index i = 0; i < rings; ++i)
    for (Index j = 0; j < sectors; ++j) {
      const double z = -1 + 2.0 * i / (rings - 1), angle = 2 * std::numbers::pi * j / sectors, r = radius(z, angle);
      shape.points.push_back({r * std::cos(angle), r * std::sin(angle), z});
      if (i == 0) continue;
      const Index a = (i - 1) * sectors + j, b = (i - 1) * sectors + (j + 1) % sectors;
      shape.faces.push_back({a, b, a + sectors});
      shape.faces.push_back({b, b + sectors, a + sectors});
    }
  return shape;
}

/// A drum with a wall that is bent outwards, closed by cones: convex, of 42 corners and 80 triangles.
scenes::Shape barrel() {
  constexpr Index kRings = 5, kSectors = 8;
  scenes::Shape shape = revolved(kRings, kSectors, [](double z, double) { return std::sqrt(1.2 - z * z); });
  const auto lower = static_cast<Index>(shape.points.size()), upper = lower + 1, top = (kRings - 1) * kSectors;
  shape.points.push_back({0, 0, -1.1});
  shape.points.push_back({0, 0, 1.1});
  for (Index j = 0; j < kSectors; ++j) {
    const Index next = (j + 1) % kSectors;
    shape.faces.push_back({lower, next, j});
    shape.faces.push_back({upper, top + j, top + next});
  }
  return shape;
}

scenes::Shape rough_ball(Random& random) {
  const scenes::SmoothNoise noise(random.bits());
  scenes::Shape ball = scenes::unit_sphere(4);
  for (Point& p : ball.points) p = scaled(p, 1 + 0.2 * noise(3 * p[0], 3 * p[1], 3 * p[2]));
  return ball;
}

/// A sheet without thickness, slightly curved.
scenes::Shape plate() {
  constexpr Index kCells = 6;
  scenes::Scene scene;
  scenes::add_grid_faces(scene, 0, kCells + 1, kCells + 1);
  scenes::Shape shape{{}, scene.faces};
  for (Index i = 0; i <= kCells; ++i)
    for (Index j = 0; j <= kCells; ++j) {
      const double x = 2.0 * i / kCells - 1, y = 2.0 * j / kCells - 1;
      shape.points.push_back({x, y, 0.03 * (x * x + y)});
    }
  return shape;
}

/// A screw thread of two turns, 0.1 deep.
scenes::Shape thread(double radius) {
  return revolved(20, 16,
                  [&](double z, double angle) { return radius + 0.05 * std::cos(2 * std::numbers::pi * z - angle); });
}

scenes::Shape turned_somehow(scenes::Shape shape, Random& random) {
  const RigidChain turned = interpolated_chain({}, {{}, scaled(direction(random), random.between(0, 3))});
  std::vector<Index> all(shape.points.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Index>(i);
  const RigidPath path(shape.points, std::vector<Index>(all.size(), 0), {turned});
  std::vector<double> errors(all.size());
  path.points_at(1, all, shape.points, errors);
  return shape;
}

/// The largest turns of a step, in rad. Bullet turns bodies by no more than the first.
constexpr double kMostOfBullet = std::numbers::pi / 4, kMost = 2.8;

/// Two bodies of radius at most `radius`, apart at the start. One goes past or into the other; each turns by up to
/// `turn`.
MovingPair meeting(scenes::Shape first, scenes::Shape second, double radius, double turn, Random& random) {
  const Point away = direction(random), aside = direction(random);
  const Point start = scaled(away, 2.01 * radius + random.between(0, 1));
  Point end = scaled(away, -random.between(0, 2));
  for (std::size_t k = 0; k < 3; ++k) end[k] += 0.7 * radius * aside[k];
  return {
      {turned_somehow(std::move(first), random), {0, 0, 0}, {0, 0, 0}, scaled(direction(random), turn * random.unit())},
      {turned_somehow(std::move(second), random), start, end, scaled(direction(random), turn * random.unit())}};
}

scenes::Shape some_box(Random& random) {
  scenes::Shape box = scenes::unit_cube(1);
  stretch(box, {random.between(0.05, 1), random.between(0.05, 1), random.between(0.05, 1)});
  return box;
}

scenes::Shape some_barrel(Random& random) {
  scenes::Shape shape = barrel();
  stretch(shape, {random.between(0.2, 1), random.between(0.2, 1), random.between(0.2, 1)});
  return shape;
}

template <class Make>
BodyScene scene(std::string name, bool is_convex, bool turns, int count, const Make& make) {
  BodyScene scene{std::move(name), is_convex, turns, {}};
  Random random(1);
  for (int i = 0; i < count; ++i) scene.pairs.push_back(make(random));
  return scene;
}

}  // namespace

std::vector<BodyScene> body_scenes(int pairs) {
  const int of_meshes = std::max(1, pairs / 10);
  return {
      scene("boxes, sliding", true, false, pairs,
            [](Random& random) { return meeting(some_box(random), some_box(random), std::sqrt(3), 0, random); }),
      scene("boxes, tumbling", true, true, pairs,
            [](Random& random) {
              return meeting(some_box(random), some_box(random), std::sqrt(3), kMostOfBullet, random);
            }),
      scene(
          "hulls of 42 corners, tumbling", true, true, pairs,
          [](Random& random) { return meeting(some_barrel(random), some_barrel(random), 1.1, kMostOfBullet, random); }),
      scene("rough balls of 192 triangles, turning", false, true, of_meshes,
            [](Random& random) { return meeting(rough_ball(random), rough_ball(random), 1.2, kMost, random); }),
      scene("curved plates of 72 triangles, tumbling", false, true, of_meshes,
            [](Random& random) { return meeting(plate(), plate(), 1.5, kMost, random); }),
      scene("nut on bolt, 608 triangles each", false, true, of_meshes,
            [](Random& random) {
              const double turn = random.between(1, 3);
              return MovingPair{{thread(0.5), {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
                                {thread(0.53), {0, 0, 0}, {0, 0, random.between(-0.2, 0.1)}, {0, 0, turn}}};
            }),
  };
}

}  // namespace tamis::bench

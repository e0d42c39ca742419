#include "integrations/bullet/throws/fine_scenes.hpp"

#include <BulletCollision/Gimpact/btGImpactShape.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "integrations/bullet/throws/body_scenes.hpp"
#include "integrations/bullet/throws/random.hpp"

namespace tamis::bullet {
namespace {

std::shared_ptr<btCollisionShape> mesh_shape(const Triangles& mesh) {
  const auto triangles = std::make_shared<btTriangleMesh>();
  const auto at = [&](Index vertex) {
    const Point& p = mesh.points[static_cast<std::size_t>(vertex)];
    return btVector3(static_cast<btScalar>(p[0]), static_cast<btScalar>(p[1]), static_cast<btScalar>(p[2]));
  };
  for (const Face& face : mesh.faces) triangles->addTriangle(at(face[0]), at(face[1]), at(face[2]));
  auto* const shape = new btGImpactMeshShape(triangles.get());
  shape->setMargin(0);
  shape->updateBound();
  return {shape, [triangles](btGImpactMeshShape* made) { delete made; }};
}

/// A gear about z with 16 triangles a tooth; the first tooth is at the angle 0. Teeth are narrower than their gaps.
Triangles gear(int teeth, double radius) {
  const double tooth = 2 * std::numbers::pi / teeth, depth = 1.6 / teeth;
  Triangles gear{{{0, 0, -0.03}, {0, 0, 0.03}}, {}};
  for (int i = 0; i < teeth; ++i)
    for (const auto& [part, height] : std::array<std::array<double, 2>, 4>{
             {{-0.3, 1 - depth}, {-0.1, 1 + depth}, {0.1, 1 + depth}, {0.3, 1 - depth}}}) {
      const double angle = (i + part) * tooth;
      for (const double z : {-0.03, 0.03})
        gear.points.push_back({radius * height * std::cos(angle), radius * height * std::sin(angle), z});
    }
  const Index corners = 4 * teeth;
  for (Index i = 0; i < corners; ++i) {
    const Index a = 2 + 2 * i, b = 2 + 2 * ((i + 1) % corners);
    gear.faces.insert(gear.faces.end(), {{a, b, b + 1}, {a, b + 1, a + 1}, {0, b, a}, {1, a + 1, b + 1}});
  }
  return gear;
}

/// A ball of radius 0.2 about the origin, in rings, with bumps.
Triangles rough_ball(int triangles) {
  const auto rings = std::max(3, static_cast<int>(std::lround(0.5 + std::sqrt(triangles / 4.0))));
  const Index around = 2 * rings;
  Triangles ball{{{0, 0, 0.2}, {0, 0, -0.2}}, {}};
  for (int ring = 1; ring < rings; ++ring)
    for (Index i = 0; i < around; ++i) {
      const double u = std::numbers::pi * ring / rings, v = 2 * std::numbers::pi * i / around;
      const double radius = 0.2 * (1 + 0.05 * std::sin(9 * u) * std::sin(11 * v));
      ball.points.push_back(
          {radius * std::sin(u) * std::cos(v), radius * std::sin(u) * std::sin(v), radius * std::cos(u)});
    }
  const auto at = [&](int ring, Index i) { return 2 + (ring - 1) * around + i % around; };
  for (Index i = 0; i < around; ++i) {
    ball.faces.push_back({0, at(1, i), at(1, i + 1)});
    for (int ring = 1; ring + 1 < rings; ++ring) {
      ball.faces.push_back({at(ring, i), at(ring + 1, i), at(ring + 1, i + 1)});
      ball.faces.push_back({at(ring, i), at(ring + 1, i + 1), at(ring, i + 1)});
    }
    ball.faces.push_back({1, at(rings - 1, i + 1), at(rings - 1, i)});
  }
  return ball;
}

}  // namespace

BodyScene gears() {
  constexpr double kRadius = 0.35, kLarger = 120. / 70, kPlay = 0.002;
  BodyScene scene;
  scene.gravity = {0, 0, 0};
  const auto away = static_cast<btScalar>(kRadius * (1 + kLarger) + kPlay);
  // A gap of the larger gear faces the first tooth of the smaller one.
  const auto half_tooth = static_cast<btScalar>(std::numbers::pi / 120);
  const btQuaternion facing({0, 0, 1}, SIMD_PI + half_tooth);
  scene.bodies = {{mesh_shape(gear(70, kRadius)), 1, btTransform::getIdentity(), {0, 0, 0}, {0, 0, 20}},
                  {mesh_shape(gear(120, kLarger * kRadius)), 3, btTransform(facing, {away, 0, 0})}};
  for (Body& body : scene.bodies) {
    body.goes = {0, 0, 0};
    body.turns = {0, 0, 1};
  }
  return scene;
}

BodyScene rough_balls(int triangles) {
  BodyScene scene = pit(0.5F);
  const auto shape = mesh_shape(rough_ball(triangles));
  Random random;
  for (int i = 0; i < 4; ++i) {
    const btVector3 position = random.vector(0.2) * btVector3(1, 0, 1);
    scene.bodies.push_back(
        {shape,
         1,
         btTransform(random.turn(), position + btVector3(0, 0.3F + 0.5F * static_cast<btScalar>(i), 0)),
         {0, -5, 0},
         random.vector(5)});
  }
  return scene;
}

}  // namespace tamis::bullet

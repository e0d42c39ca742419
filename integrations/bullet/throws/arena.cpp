#include "integrations/bullet/throws/arena.hpp"

#include <BulletCollision/Gimpact/btGImpactShape.h>

#include <ctime>

#include "integrations/bullet/mesh_of_shape.hpp"
#include "integrations/bullet/throws/parts.hpp"

namespace tamis::bullet {
namespace {

std::unique_ptr<btTriangleMesh> triangles_of(const Triangles& mesh) {
  auto triangles = std::make_unique<btTriangleMesh>();
  const auto at = [&](Index vertex) { return vector_of(mesh.points[static_cast<std::size_t>(vertex)]); };
  for (const Face& face : mesh.faces) triangles->addTriangle(at(face[0]), at(face[1]), at(face[2]));
  return triangles;
}

bool is_hull(Method method) {
  return method == Method::hull || method == Method::hull_ccd || method == Method::clamped_hull;
}
bool is_clamped(Method method) { return method == Method::clamped_hull || method == Method::clamped_mesh; }

}  // namespace

Triangles box(const Point& half_extents) {
  Triangles box;
  for (const int x : {-1, 1})
    for (const int y : {-1, 1})
      for (const int z : {-1, 1}) box.points.push_back({x * half_extents[0], y * half_extents[1], z * half_extents[2]});
  box.faces = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
               {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
  return box;
}

Triangles wall(int cells, double half_side) {
  Triangles wall;
  const auto at = [&](int i) { return half_side * (2.0 * i / cells - 1); };
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j <= cells; ++j) wall.points.push_back({at(i), at(j), 0});
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      const Index a = i * (cells + 1) + j, b = a + cells + 1;
      wall.faces.push_back({a, b, a + 1});
      wall.faces.push_back({a + 1, b, b + 1});
    }
  return wall;
}

std::string_view name_of(Method method) {
  switch (method) {
    case Method::hull:
      return "Bullet, hull";
    case Method::hull_ccd:
      return "Bullet, hull with CCD";
    case Method::mesh:
      return "Bullet, mesh (btGImpact)";
    case Method::clamped_hull:
      return "clamped, hull";
    case Method::clamped_mesh:
      return "clamped, mesh (btGImpact)";
  }
  return "?";
}

Arena::Arena(Triangles fixed, Triangles flying, double swept_radius)
    : fixed_(std::move(fixed)),
      flying_(std::move(flying)),
      swept_radius_(swept_radius),
      fixed_triangles_(triangles_of(fixed_)),
      flying_triangles_(triangles_of(flying_)),
      fixed_shape_(std::make_unique<btBvhTriangleMeshShape>(fixed_triangles_.get(), true)) {}

Arena::~Arena() = default;

std::unique_ptr<btCollisionShape> Arena::shape_for(Method method) const {
  if (is_hull(method)) {
    auto hull = std::make_unique<btConvexHullShape>();
    for (const Point& p : flying_.points) hull->addPoint(vector_of(p), false);
    hull->recalcLocalAabb();
    return hull;
  }
  auto mesh = std::make_unique<btGImpactMeshShape>(flying_triangles_.get());
  mesh->updateBound();
  return mesh;
}

Flight Arena::fly(Method method, const Throw& thrown) const {
  Parts parts(is_clamped(method));
  btRigidBody fixed(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, fixed_shape_.get()));
  const std::unique_ptr<btCollisionShape> shape = shape_for(method);
  btVector3 inertia;
  shape->calculateLocalInertia(1, inertia);
  btRigidBody flying(btRigidBody::btRigidBodyConstructionInfo(1, nullptr, shape.get(), inertia));
  btTransform start = btTransform::getIdentity();
  start.setOrigin(vector_of(thrown.position));
  flying.setWorldTransform(start);
  flying.setInterpolationWorldTransform(start);
  flying.setLinearVelocity(vector_of(thrown.velocity));
  flying.setAngularVelocity(vector_of(thrown.spin));
  if (thrown.on_axle) {
    flying.setLinearFactor({0, 0, 0});
    flying.setAngularFactor({0, 0, 1});
  }
  if (method == Method::hull_ccd) {  // as pybullet sets them
    flying.setCcdSweptSphereRadius(static_cast<btScalar>(swept_radius_));
    flying.setCcdMotionThreshold(static_cast<btScalar>(swept_radius_ / 2));
  }
  parts.world->addRigidBody(&fixed);
  parts.world->addRigidBody(&flying);
  Flight flight;
  flight.places.push_back(start);
  const auto seconds = static_cast<btScalar>(thrown.seconds);
  const std::clock_t begin = std::clock();
  for (int step = 0; step < thrown.steps; ++step) {
    parts.world->stepSimulation(seconds, 1, seconds);
    flight.places.push_back(flying.getWorldTransform());
  }
  flight.milliseconds = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  parts.world->removeRigidBody(&flying);
  parts.world->removeRigidBody(&fixed);
  return flight;
}

}  // namespace tamis::bullet

// A clamped Bullet world for tests.
#pragma once
#include <memory>
#include <vector>

#include "integrations/bullet/clamped_world.hpp"

namespace tamis::bullet {

/// A world, and bodies that it keeps alive.
struct Simulation {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  std::vector<std::unique_ptr<btRigidBody>> bodies;
  ClampedWorld world{&dispatcher, &broadphase, &solver, &configuration};

  ~Simulation() {
    for (const auto& body : bodies) world.removeRigidBody(body.get());
  }

  /// Upright, at rest; a mass of 0: fixed.
  btRigidBody& add(btCollisionShape& shape, btScalar mass, const btVector3& position) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0) shape.calculateLocalInertia(mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, inertia);
    info.m_startWorldTransform.setOrigin(position);
    auto body = std::make_unique<btRigidBody>(info);
    world.addRigidBody(body.get());
    bodies.push_back(std::move(body));
    return *bodies.back();
  }

  void run(int steps) {
    for (int i = 0; i < steps; ++i) world.stepSimulation(1.0F / 60, 1, 1.0F / 60);
  }
};

}  // namespace tamis::bullet

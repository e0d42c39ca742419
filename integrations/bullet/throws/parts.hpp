// A Bullet world with the objects that it needs.
#pragma once
#include <btBulletDynamicsCommon.h>

#include <memory>

namespace tamis::bullet {

struct Parts {
  /// The world has no gravity. `clamped`: it is a ClampedWorld, otherwise Bullet's own.
  explicit Parts(bool clamped);

  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  std::unique_ptr<btDiscreteDynamicsWorld> world;
};

}  // namespace tamis::bullet

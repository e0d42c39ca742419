// What a Bullet world needs around it.
#pragma once
#include <btBulletDynamicsCommon.h>

#include <memory>

namespace tamis::bullet {

struct Parts {
  /// Without gravity; a ClampedWorld, or Bullet as it is.
  explicit Parts(bool clamped);

  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  std::unique_ptr<btDiscreteDynamicsWorld> world;
};

}  // namespace tamis::bullet

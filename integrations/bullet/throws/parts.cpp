#include "integrations/bullet/throws/parts.hpp"

#include <BulletCollision/Gimpact/btGImpactCollisionAlgorithm.h>

#include "integrations/bullet/clamped_world.hpp"

namespace tamis::bullet {

Parts::Parts(bool clamped) {
  btGImpactCollisionAlgorithm::registerAlgorithm(&dispatcher);
  if (clamped)
    world = std::make_unique<ClampedWorld>(&dispatcher, &broadphase, &solver, &configuration);
  else
    world = std::make_unique<btDiscreteDynamicsWorld>(&dispatcher, &broadphase, &solver, &configuration);
  world->setGravity({0, 0, 0});
}

}  // namespace tamis::bullet

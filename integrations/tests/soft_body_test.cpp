// Soft bodies in a truncated world: ropes, bodies that come in a callback, bodies that have nothing to meet.
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btSoftBodyHelpers.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <btBulletDynamicsCommon.h>
#include <gtest/gtest.h>

#include <memory>

#include "integrations/bullet/truncated_world.hpp"

namespace tamis::bullet {
namespace {

/// Without gravity. The world frees the soft bodies that are in it.
struct SoftSimulation {
  btSoftBodyRigidBodyCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btDeformableMultiBodyConstraintSolver solver;
  btDeformableBodySolver deformable;
  TruncatedWorld world{&dispatcher, &broadphase, &solver, &configuration, &deformable};
  std::vector<std::unique_ptr<btSoftBody>> bodies;

  SoftSimulation() {
    solver.setDeformableSolver(&deformable);
    world.setGravity({0, 0, 0});
    btSoftBodyWorldInfo& info = world.getWorldInfo();
    info.m_broadphase = &broadphase;
    info.m_dispatcher = &dispatcher;
    info.m_gravity = {0, 0, 0};
    info.m_sparsesdf.Initialize();
  }
  ~SoftSimulation() {
    for (const auto& body : bodies) world.removeSoftBody(body.get());
  }

  btSoftBody& add(btSoftBody* body) {
    bodies.emplace_back(body);
    world.addSoftBody(body);
    return *body;
  }
  void run(int steps) {
    for (int i = 0; i < steps; ++i) world.stepSimulation(1.0F / 60, 1, 1.0F / 60);
  }
};

btSoftBody* patch(SoftSimulation& simulation) {
  return btSoftBodyHelpers::CreatePatch(simulation.world.getWorldInfo(), {-1, 0, -1}, {1, 0, -1}, {-1, 0, 1}, {1, 0, 1},
                                        5, 5, 0, false);
}

/// The bug: a body without triangles made each step fail.
TEST(TruncatedWorld, StopsARopeAtItself) {
  SoftSimulation simulation;
  btSoftBody& rope =
      simulation.add(btSoftBodyHelpers::CreateRope(simulation.world.getWorldInfo(), {0, 0, 0}, {1, 0, 0}, 2, 0));
  const btVector3 corners[]{{-1, 0, 0}, {1, 0, 0}, {0, 1, 0.5F}, {0, -1, 0.5F}};  // the last link is above the first
  for (int i = 0; i < 4; ++i) rope.m_nodes[i].m_x = rope.m_nodes[i].m_q = corners[i];
  rope.updateNormals();
  for (int i : {2, 3}) rope.m_nodes[i].m_v = {0, 0, -60};
  simulation.run(1);
  EXPECT_GT(simulation.world.held_back(), 0);
  EXPECT_GT(rope.m_nodes[2].m_x.z() + rope.m_nodes[3].m_x.z(), rope.m_nodes[0].m_x.z() + rope.m_nodes[1].m_x.z());
}

TEST(TruncatedWorld, TakesTheLinksOfRopesAlone) {
  SoftSimulation simulation;
  btSoftBody& cloth = simulation.add(patch(simulation));
  cloth.generateBendingConstraints(2);
  EXPECT_TRUE(features_of(cloth).edges.empty());
  cloth.appendNode({0, 5, 0}, 1);
  cloth.appendLink(0, cloth.m_nodes.size() - 1);
  EXPECT_EQ(features_of(cloth).edges.size(), 1U);
  EXPECT_EQ(features_of(cloth).faces.size(), 32U);
}

/// The bug: an exception of std::map out of the step.
TEST(TruncatedWorld, TakesABodyThatIsAddedInTheCallbackBeforeAStep) {
  SoftSimulation simulation;
  const auto add = [](btDynamicsWorld* world, btScalar) {
    auto* const owner = static_cast<SoftSimulation*>(world->getWorldUserInfo());
    if (owner->bodies.empty()) owner->add(patch(*owner)).setVelocity({1, 0, 0});
  };
  simulation.world.setInternalTickCallback(add, &simulation, true);
  simulation.run(1);
  ASSERT_EQ(simulation.bodies.size(), 1U);
  const btScalar before = simulation.bodies[0]->m_nodes[0].m_x.x();
  simulation.run(3);
  EXPECT_GT(simulation.bodies[0]->m_nodes[0].m_x.x(), before + 0.02F) << "it goes as Bullet moves it";
}

TEST(TruncatedWorld, DoesNotLookAtABodyWithoutLinksAndFaces) {
  SoftSimulation simulation;
  const btVector3 place(0, 0, 0);
  const btScalar mass = 1;
  btSoftBody& body = simulation.add(new btSoftBody(&simulation.world.getWorldInfo(), 1, &place, &mass));
  body.m_nodes[0].m_v = {1, 0, 0};
  simulation.run(2);
  EXPECT_GT(body.m_nodes[0].m_x.x(), 0.005F) << "it goes as Bullet moves it";
  EXPECT_EQ(simulation.world.held_back(), 0);
}

}  // namespace
}  // namespace tamis::bullet

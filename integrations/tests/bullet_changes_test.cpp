// What callers of Bullet change between two steps: shapes in place, shapes at old addresses, flags; and what motion
// states show.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <new>

#include "integrations/bullet/mesh_of_shape.hpp"
#include "integrations/tests/bullet_simulation.hpp"
#include "tamis/error.hpp"

namespace tamis::bullet {
namespace {

/// A cube flies along x towards the origin, after `before` and a first step with `obstacle` there. Where it ends.
btScalar thrown_at(btCollisionShape& obstacle, const std::function<void(Simulation&, btRigidBody&)>& before) {
  btBoxShape cube({0.1F, 0.1F, 0.1F});
  Simulation simulation;
  simulation.world.setGravity({0, 0, 0});
  btRigidBody& fixed = simulation.add(obstacle, 0, {0, 0, 0});
  btRigidBody& body = simulation.add(cube, 1, {2, 1, 0});
  simulation.run(1);
  before(simulation, fixed);
  simulation.world.updateSingleAabb(&fixed);
  body.setLinearVelocity({-200, 0, 0});
  simulation.run(3);
  return body.getWorldTransform().getOrigin().x();
}

constexpr btScalar kSmall = 0.01F;

/// The bug: a mesh was kept as long as the pointer to its shape was the same.
TEST(ClampedWorld, SeesACompoundThatGetsAChild) {
  btBoxShape grain({kSmall, kSmall, kSmall}), wall({kSmall, 5, 5});
  btCompoundShape compound;
  compound.addChildShape(btTransform(btQuaternion(0, 0, 0, 1), {-50, 0, 0}), &grain);
  const auto add_wall = [&](Simulation&, btRigidBody&) { compound.addChildShape(btTransform::getIdentity(), &wall); };
  EXPECT_GT(thrown_at(compound, add_wall), 0);
}

TEST(ClampedWorld, SeesACompoundWhoseChildIsPutElsewhere) {
  btBoxShape wall({kSmall, 5, 5});
  btCompoundShape compound;
  compound.addChildShape(btTransform(btQuaternion(0, 0, 0, 1), {-50, 0, 0}), &wall);
  const auto put = [&](Simulation&, btRigidBody&) { compound.updateChildTransform(0, btTransform::getIdentity()); };
  EXPECT_GT(thrown_at(compound, put), 0);
}

TEST(ClampedWorld, SeesAShapeThatIsScaled) {
  btBoxShape grain({kSmall, kSmall, kSmall});
  EXPECT_GT(thrown_at(grain, [&](Simulation&, btRigidBody&) { grain.setLocalScaling({1, 500, 500}); }), 0);
}

TEST(ClampedWorld, SeesAHullThatGetsAPoint) {
  btConvexHullShape hull;
  for (const btVector3& p : {btVector3(0, 0.1F, 0), btVector3(0.1F, 0, 0), btVector3(0, 0, 0.1F)}) hull.addPoint(p);
  EXPECT_GT(thrown_at(hull, [&](Simulation&, btRigidBody&) { hull.addPoint({0, 9, 0}); }), 0);
}

/// The caller may free a shape and make another one at the same place.
TEST(ClampedWorld, TellsShapesApartThatWereMadeAtOneAddress) {
  alignas(btBoxShape) std::array<std::byte, sizeof(btBoxShape)> memory;
  for (const bool has_mesh : {false, true}) {
    auto* const grain = new (memory.data()) btBoxShape({kSmall, kSmall, kSmall});
    const auto replace = [&](Simulation& simulation, btRigidBody& fixed) {
      if (has_mesh) simulation.world.set_mesh(*grain, mesh_of(*grain));
      grain->~btBoxShape();
      fixed.setCollisionShape(new (memory.data()) btBoxShape({kSmall, 5, 5}));
    };
    EXPECT_GT(thrown_at(*grain, replace), 0);
  }
}

/// Bug: a mesh that was given after the body had been added counted for nothing.
TEST(ClampedWorld, TakesAMeshThatIsGivenForABodyThatIsThere) {
  btBoxShape wall({0.1F, 5, 5}), box({0.1F, 0.1F, 0.1F});
  Simulation simulation;
  simulation.world.setGravity({0, 0, 0});
  simulation.add(wall, 0, {2, 0, 0});
  btRigidBody& body = simulation.add(box, 1, {0, 0, 0});
  simulation.world.set_mesh(box, mesh_of(btBoxShape({1, 0.1F, 0.1F})));
  body.setLinearVelocity({60, 0, 0});
  simulation.run(2);
  EXPECT_NEAR(body.getWorldTransform().getOrigin().x(), 0.9, 0.01);
}

TEST(ClampedWorld, RefusesAGapThatIsNone) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  EXPECT_THROW(ClampedWorld(&dispatcher, &broadphase, &solver, &configuration, {.gap = -1}), InvalidOptions);
}

TEST(ClampedWorld, KeepsAGivenMeshWhereOnlyTheMarginChanges) {
  btBoxShape grain({kSmall, kSmall, kSmall});
  const auto give = [&](Simulation& simulation, btRigidBody& fixed) {
    simulation.world.removeRigidBody(&fixed);
    simulation.world.set_mesh(grain, mesh_of(btBoxShape({kSmall, 5, 5})));
    grain.setMargin(0.001F);
    simulation.world.addRigidBody(&fixed);
  };
  EXPECT_GT(thrown_at(grain, give), 0);
}

/// The bug: a shape without triangles was refused once, and its body forgotten in the next step.
TEST(ClampedWorld, RefusesEachStepOfABodyWhoseShapeHasNoTriangles) {
  btBoxShape box({1, 1, 1});
  btSphereShape sphere(1);
  Simulation simulation;
  btRigidBody& body = simulation.add(box, 1, {0, 0, 0});
  body.setCollisionShape(&sphere);
  for (int i = 0; i < 3; ++i) EXPECT_THROW(simulation.run(1), InvalidMesh) << i;
  body.setCollisionShape(&box);
  simulation.run(1);
}

/// The bug: an object without contact response was not looked at, whatever became of it.
TEST(ClampedWorld, StopsBodiesAtObjectsThatRespond) {
  btBoxShape wall({kSmall, 5, 5}), cube({0.1F, 0.1F, 0.1F});
  constexpr int kNoResponse = btCollisionObject::CF_NO_CONTACT_RESPONSE;
  for (const bool ends_solid : {false, true}) {
    Simulation simulation;
    simulation.world.setGravity({0, 0, 0});
    btCollisionObject gate;
    gate.setCollisionShape(&wall);
    const int solid = gate.getCollisionFlags();
    gate.setCollisionFlags(ends_solid ? solid | kNoResponse : solid);
    simulation.world.addCollisionObject(&gate);
    btRigidBody& body = simulation.add(cube, 1, {2, 0, 0});
    simulation.run(1);
    gate.setCollisionFlags(ends_solid ? solid : solid | kNoResponse);
    body.setLinearVelocity({-200, 0, 0});
    simulation.run(3);
    EXPECT_EQ(body.getWorldTransform().getOrigin().x() > 0, ends_solid);
    simulation.world.removeCollisionObject(&gate);
  }
}

/// The bug: what motion states show of a body that was held back lay behind where it had been, beyond the wall there.
TEST(ClampedWorld, ShowsABodyOnItsProvenWay) {
  btBoxShape wall({kSmall, 5, 5}), cube({0.1F, 0.1F, 0.1F});
  Simulation simulation;
  simulation.world.setGravity({0, 0, 0});
  for (const btScalar x : {0.0F, 0.35F}) simulation.add(wall, 0, {x, 0, 0});
  btRigidBody& body = simulation.add(cube, 1, {0.2F, 0, 0});
  btDefaultMotionState shown(body.getWorldTransform());
  body.setMotionState(&shown);
  body.setLinearVelocity({-60, 0, 0});
  for (int i = 0; i < 10; ++i) {
    simulation.world.stepSimulation(1.0F / 144, 4, 1.0F / 60);
    EXPECT_GT(shown.m_graphicsWorldTrans.getOrigin().x(), 0.11F);
    EXPECT_LT(shown.m_graphicsWorldTrans.getOrigin().x(), 0.201F);
  }
}

/// That overlaps are looked for again: two bodies that passed through each other unproven.
TEST(ClampedWorld, SeesAnOverlapOfBodiesThatCollideFromNowOn) {
  btBoxShape cube({1, 1, 1});
  Simulation simulation;
  simulation.world.setGravity({0, 0, 0});
  btRigidBody& fixed = simulation.add(cube, 0, {0, 0, 0});
  btRigidBody& body = simulation.add(cube, 1, {0.1F, 0.2F, 3});
  body.setIgnoreCollisionCheck(&fixed, true);
  body.setLinearVelocity({0, 0, -60});
  simulation.run(2);
  body.setLinearVelocity({0, 0, 0});
  simulation.run(2);
  EXPECT_EQ(simulation.world.last_step().overlapping, 0U);
  body.setIgnoreCollisionCheck(&fixed, false);
  simulation.run(1);
  EXPECT_EQ(simulation.world.last_step().overlapping, 1U);
}

/// Bullet moves what was added as a body that moves, and nothing else.
TEST(ClampedWorld, LeavesWhereItIsWhatBulletDoesNotMove) {
  btBoxShape cube({0.1F, 0.1F, 0.1F});
  Simulation simulation;
  btRigidBody& body = simulation.add(cube, 0, {0, 0, 0});
  body.setCollisionFlags(body.getCollisionFlags() & ~btCollisionObject::CF_STATIC_OBJECT);
  body.setMassProps(1, {1, 1, 1});
  body.setLinearVelocity({-200, 0, 0});
  simulation.run(2);
  EXPECT_EQ(body.getWorldTransform().getOrigin().x(), 0);
}

}  // namespace
}  // namespace tamis::bullet

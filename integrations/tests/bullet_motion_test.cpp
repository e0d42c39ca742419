// Bullet's world with the clamp: bodies move on as they should once they have been held back.
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <gtest/gtest.h>

#include <random>

#include "integrations/tests/bullet_simulation.hpp"

namespace tamis::bullet {
namespace {

/// Bug: a turned box that was held back just above the floor kept its speed, gravity added to it, and it hung there for
/// ever: nineteen of twenty at this speed.
TEST(ClampedWorld, LetsABoxThatFallsFastComeToRest) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<btScalar> number(-1, 1);
    const auto vector = [&] { return btVector3(number(random), number(random), number(random)); };
    btBoxShape floor({20, 0.5F, 20}), box({0.03F, 0.02F, 0.04F});
    Simulation simulation;
    simulation.add(floor, 0, {0, -0.5F, 0});
    btRigidBody& body = simulation.add(box, 1, {0, 0.6F, 0});
    body.setCenterOfMassTransform(btTransform(btQuaternion(vector().normalized(), 3 * number(random)), {0, 0.6F, 0}));
    body.setLinearVelocity({5 * number(random), -20, 5 * number(random)});
    simulation.run(240);
    EXPECT_LT(body.getWorldTransform().getOrigin().y(), 0.05) << seed;
    EXPECT_LT(body.getLinearVelocity().length(), 1) << seed;
  }
}

/// Bug: a contact that had held the body back pushed it where it no longer was.
TEST(ClampedWorld, ForgetsWhatHeldABodyBackThatIsPutElsewhere) {
  btBoxShape wall({0.05F, 5, 5}), box({0.1F, 0.1F, 0.1F});
  Simulation simulation;
  simulation.world.setGravity({0, 0, 0});
  simulation.add(wall, 0, {0, 0, 0});
  btRigidBody& body = simulation.add(box, 1, {-1, 0, 0});
  body.setLinearVelocity({30, 0, 0});
  simulation.run(2);
  ASSERT_LT(simulation.world.last_step().moved.at(0).second, 1);
  body.setCenterOfMassTransform(btTransform(btQuaternion::getIdentity(), {5, 0, 0}));
  body.setLinearVelocity({0, 0, 0});
  simulation.run(2);
  EXPECT_EQ(body.getWorldTransform().getOrigin().x(), 5);
}

/// Bug: bodies that lie exactly on each other overlap, within rounding; Bullet parted them by nothing, so they were
/// never held back on account of each other.
TEST(ClampedWorld, PartsBodiesThatBeginExactlyOnEachOther) {
  btBoxShape floor({5, 0.5F, 5}), box({0.5F, 0.5F, 0.5F});
  Simulation simulation;
  simulation.add(floor, 0, {0, -0.5F, 0});
  for (int i = 0; i < 4; ++i) simulation.add(box, 1, {0, 0.5F + static_cast<btScalar>(i), 0});
  simulation.run(60);
  EXPECT_EQ(simulation.world.last_step().overlapping, 0U);
  for (std::size_t i = 1; i < simulation.bodies.size(); ++i)
    EXPECT_NEAR(simulation.bodies[i]->getWorldTransform().getOrigin().y(), 0.501 * static_cast<double>(2 * i - 1),
                0.02);
}

/// Bug: the pairs of the last step named a body that was no more.
TEST(ClampedWorld, DetectsCollisionsBetweenStepsAfterABodyWasRemoved) {
  btBoxShape box({1, 1, 1});
  Simulation simulation;
  simulation.world.setGravity({0, 0, 0});
  simulation.add(box, 1, {0, 0, 0});
  simulation.add(box, 1, {1.5F, 0, 0});
  simulation.run(1);
  ASSERT_EQ(simulation.world.last_step().overlapping, 1U);
  simulation.world.removeRigidBody(simulation.bodies[1].get());
  simulation.bodies.pop_back();
  EXPECT_NO_THROW(simulation.world.performDiscreteCollisionDetection());
}

/// Bug: where nothing stands, a body was pushed away from one that took no impulse.
TEST(ClampedWorld, KeepsTheMomentumOfBodiesThatAreFree) {
  btBoxShape box({0.2F, 0.2F, 0.2F});
  Simulation simulation;
  simulation.world.setGravity({0, 0, 0});
  for (int i = 0; i < 6; ++i) simulation.add(box, 1, {0.4015F * static_cast<btScalar>(i), 0, 0});
  simulation.bodies[0]->setCenterOfMassTransform(btTransform(btQuaternion::getIdentity(), {-1, 0, 0}));
  simulation.bodies[0]->setLinearVelocity({5, 0, 0});
  simulation.run(60);
  btScalar momentum = 0;
  for (const auto& body : simulation.bodies) momentum += body->getLinearVelocity().x();
  EXPECT_NEAR(momentum, 5, 0.05);
}

/// Bug: contacts that carry a body had Bullet's usual friction, whatever the caller had said.
TEST(ClampedWorld, HeedsTheCallersFriction) {
  const CalculateCombinedCallback usual = gCalculateCombinedFrictionCallback;
  gCalculateCombinedFrictionCallback = [](const btCollisionObject*, const btCollisionObject*) { return btScalar(0); };
  btBoxShape floor({50, 0.5F, 5}), box({0.2F, 0.2F, 0.2F});
  Simulation simulation;
  simulation.add(floor, 0, {0, -0.5F, 0});
  btRigidBody& body = simulation.add(box, 1, {-20, 0.202F, 0});
  body.setLinearVelocity({3, 0, 0});
  simulation.run(120);
  gCalculateCombinedFrictionCallback = usual;
  EXPECT_NEAR(body.getLinearVelocity().x(), 3, 0.05);
}

/// What sleeps is told to the world of bodies as one that is fixed.
TEST(ClampedWorld, StopsAFastBodyAtOneThatSleeps) {
  btBoxShape plate({0.005F, 1, 1}), box({0.1F, 0.1F, 0.1F});
  Simulation simulation;
  simulation.world.setGravity({0, 0, 0});
  btRigidBody& sleeper = simulation.add(plate, 100, {0, 0, 0});
  btRigidBody& fast = simulation.add(box, 1, {-30, 0, 0});
  simulation.run(150);
  ASSERT_FALSE(sleeper.isActive());
  fast.activate();
  fast.setLinearVelocity({60, 0, 0});
  simulation.run(60);
  EXPECT_LT(fast.getWorldTransform().getOrigin().x(), sleeper.getWorldTransform().getOrigin().x());
}

}  // namespace
}  // namespace tamis::bullet

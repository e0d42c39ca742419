// Bullet's world with the clamp: shapes, bodies that come and go, filters, worlds that overlap, stacks.
#include <BulletCollision/CollisionShapes/btConvexTriangleMeshShape.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "integrations/bullet/mesh_of_shape.hpp"
#include "integrations/bullet/throws/arena.hpp"
#include "integrations/tests/bullet_simulation.hpp"
#include "tamis/error.hpp"

namespace tamis::bullet {
namespace {

TEST(MeshOfShape, HasTheFacesOfABox) {
  const btBoxShape box({1, 2, 3});
  const Shape mesh = mesh_of(box);
  EXPECT_EQ(mesh.points().size(), 8U);
  EXPECT_EQ(mesh.mesh().faces().size(), 12U);
  for (const Point& p : mesh.points()) {
    EXPECT_EQ(std::abs(p[0]), 1);
    EXPECT_EQ(std::abs(p[1]), 2);
    EXPECT_EQ(std::abs(p[2]), 3);
  }
}

TEST(MeshOfShape, PutsTheChildrenOfACompoundWhereTheyAre) {
  btBoxShape box({1, 1, 1});
  btCompoundShape pair;
  for (const btScalar x : {-5.0F, 5.0F}) pair.addChildShape(btTransform(btQuaternion(0, 0, 0, 1), {x, 0, 0}), &box);
  const Shape mesh = mesh_of(pair);
  EXPECT_EQ(mesh.points().size(), 16U);
  for (const Point& p : mesh.points()) EXPECT_TRUE(std::abs(p[0]) == 4 || std::abs(p[0]) == 6) << p[0];
}

/// Bug: it was refused as a list of triangles that the caller had not filled.
TEST(MeshOfShape, HasTheHullOfAConvexTriangleMesh) {
  btTriangleMesh tetrahedron;
  const btVector3 corners[]{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int i = 0; i < 4; ++i) tetrahedron.addTriangle(corners[i], corners[(i + 1) % 4], corners[(i + 2) % 4]);
  btConvexTriangleMeshShape shape(&tetrahedron);
  EXPECT_EQ(mesh_of(shape).points().size(), 4U);
  EXPECT_EQ(mesh_of(shape).mesh().faces().size(), 4U);
  const std::vector<btScalar> before = traits_of(shape);
  shape.setLocalScaling({2, 1, 1});
  EXPECT_NE(traits_of(shape), before);
}

/// Bug: each was told to call updateBound.
TEST(MeshOfShape, SaysWhatToDoAboutAShapeWithoutTriangles) {
  const auto refusal = [](const btCollisionShape& shape) {
    try {
      mesh_of(shape);
    } catch (const InvalidMesh& refused) {
      return std::string(refused.what());
    }
    return std::string();
  };
  btEmptyShape empty;
  EXPECT_NE(refusal(empty).find("CF_NO_CONTACT_RESPONSE"), std::string::npos) << refusal(empty);
  btGImpactCompoundShape compound;
  EXPECT_NE(refusal(compound).find("btCompoundShape"), std::string::npos) << refusal(compound);
  btSphereShape sphere(1);
  EXPECT_NE(refusal(sphere).find("set_mesh"), std::string::npos) << refusal(sphere);
}

TEST(MeshOfShape, RefusesWhatHasNoTriangles) {
  EXPECT_THROW(mesh_of(btSphereShape(1)), InvalidMesh);
  EXPECT_THROW(mesh_of(btStaticPlaneShape({0, 0, 1}, 0)), InvalidMesh);
  Simulation simulation;
  btSphereShape sphere(1);
  try {
    simulation.add(sphere, 1, {7, 0, 0});
    ADD_FAILURE() << "a sphere was taken";
  } catch (const InvalidMesh& refused) {
    EXPECT_NE(std::string(refused.what()).find("the object at 7.0"), std::string::npos) << refused.what();
  }
  EXPECT_EQ(simulation.world.getNumCollisionObjects(), 0);
  EXPECT_EQ(simulation.world.getNonStaticRigidBodies().size(), 0);
  simulation.world.set_mesh(sphere, mesh_of(btBoxShape({1, 1, 1})));
  simulation.add(sphere, 1, {0, 0, 0});
  EXPECT_EQ(simulation.world.getNumCollisionObjects(), 1);
}

TEST(ClampedWorld, MovesABodyThatMeetsNobodyAsBulletDoes) {
  btBoxShape box({1, 1, 1});
  Simulation simulation;
  btRigidBody& body = simulation.add(box, 1, {0, 0, 0});
  body.setAngularVelocity({3, 1, 2});
  for (int i = 0; i < 10; ++i) {
    simulation.run(1);
    EXPECT_EQ(simulation.world.last_step().questions, 1);
  }
  EXPECT_NEAR(body.getWorldTransform().getOrigin().y(), -10 * 55 / 3600.0, 1e-5);  // 1 + 2 + ... + 10 steps of gravity
}

/// A box within another one that stands, after the first step.
class OverlappingBoxes : public testing::Test {
 protected:
  OverlappingBoxes() {
    simulation.world.setGravity({0, 0, 0});
    simulation.add(box, 0, {0, 0, 0});
    body = &simulation.add(box, 1, {0.1F, 0.2F, 1.5F});
    simulation.run(1);
    EXPECT_EQ(simulation.world.last_step().overlapping, 1U);
  }

  btBoxShape box{{1, 1, 1}};
  Simulation simulation;
  btRigidBody* body;
};

TEST_F(OverlappingBoxes, ComeApart) {
  simulation.run(120);
  EXPECT_EQ(simulation.world.last_step().overlapping, 0U);
  EXPECT_GT(body->getWorldTransform().getOrigin().z(), 1.9F);
}

/// While they overlap they are not asked about; afterwards they are.
TEST_F(OverlappingBoxes, StopAtEachOtherOnceApart) {
  body->setCenterOfMassTransform(btTransform(btQuaternion::getIdentity(), {0, 0, 4}));
  body->setLinearVelocity({0, 0, -500});
  simulation.run(3);
  EXPECT_GT(body->getWorldTransform().getOrigin().z(), 2);
}

TEST(ClampedWorld, StopsAFastBodyUnlessBulletLetsItPass) {
  btBoxShape box({0.1F, 0.1F, 0.1F}), wall({0.01F, 5, 5});
  for (const bool is_ignored : {false, true}) {
    Simulation simulation;
    simulation.world.setGravity({0, 0, 0});
    btRigidBody& fixed = simulation.add(wall, 0, {0, 0, 0});
    btRigidBody& body = simulation.add(box, 1, {2, 0, 0});
    body.setIgnoreCollisionCheck(&fixed, is_ignored);
    body.setLinearVelocity({-200, 0, 0});
    simulation.run(5);
    EXPECT_EQ(body.getWorldTransform().getOrigin().x() < 0, is_ignored);
  }
}

TEST(ClampedWorld, FollowsBodiesThatAreMovedAndRemoved) {
  btBoxShape box({0.1F, 0.1F, 0.1F}), wall({0.01F, 5, 5});
  Simulation simulation;
  simulation.world.setGravity({0, 0, 0});
  btRigidBody& fixed = simulation.add(wall, 0, {0, 0, 0});
  btRigidBody& body = simulation.add(box, 1, {2, 0, 0});
  body.setLinearVelocity({-200, 0, 0});
  fixed.setWorldTransform(btTransform(btQuaternion(0, 0, 0, 1), {-3, 0, 0}));
  simulation.run(3);
  EXPECT_LT(body.getWorldTransform().getOrigin().x(), 0);
  EXPECT_GT(body.getWorldTransform().getOrigin().x(), -3);
  simulation.world.removeRigidBody(&fixed);
  body.setLinearVelocity({-200, 0, 0});
  simulation.run(3);
  EXPECT_LT(body.getWorldTransform().getOrigin().x(), -3);
}

/// The floor's margin holds the plate, so that the solver moves it up by a centimetre at once, without a velocity; a
/// sheet is in its way.
TEST(ClampedWorld, HoldsBackWhatTheSolverMovesOutOfAMargin) {
  const auto hull_of = [](const btVector3& half) {
    auto hull = std::make_unique<btConvexHullShape>();
    for (const Point& p : box({half.x(), half.y(), half.z()}).points) hull->addPoint(vector_of(p));
    return hull;
  };
  const auto floor = hull_of({5, 0.5F, 5}), plate = hull_of({0.2F, 0.002F, 0.2F});
  btBoxShape sheet({5, 0.0005F, 5});
  Simulation simulation;
  simulation.world.setGravity({0, 0, 0});
  simulation.add(*floor, 0, {0, -0.5F, 0});
  const btRigidBody& body = simulation.add(*plate, 1, {0, 0.005F, 0});
  simulation.add(sheet, 0, {0, 0.012F, 0});
  for (int i = 0; i < 30; ++i) {
    simulation.run(1);
    ASSERT_LT(body.getWorldTransform().getOrigin().y(), 0.012F) << "step " << i;
  }
}

/// Thin plates, thinner than what gravity moves one in two steps.
TEST(ClampedWorld, KeepsAPileOfThinPlates) {
  btBoxShape floor({5, 0.5F, 5}), plate({0.5F, 0.0025F, 0.5F});
  Simulation simulation;
  simulation.add(floor, 0, {0, -0.5F, 0});
  constexpr int kPlates = 6;
  const auto shift = [](int i) { return 0.01F * static_cast<btScalar>(i % 3); };
  for (int i = 0; i < kPlates; ++i) simulation.add(plate, 1, {shift(i), 0.01F + 0.008F * static_cast<btScalar>(i), 0});
  simulation.run(40);
  EXPECT_EQ(simulation.world.last_step().overlapping, 0U);
  for (int i = 1; i <= kPlates; ++i) {
    const btVector3& place = simulation.bodies[static_cast<std::size_t>(i)]->getWorldTransform().getOrigin();
    const btVector3& below = simulation.bodies[static_cast<std::size_t>(i - 1)]->getWorldTransform().getOrigin();
    EXPECT_GT(place.y(), i == 1 ? 0.0025F : below.y() + 0.005F) << "plate " << i;
    EXPECT_NEAR(place.x(), shift(i - 1), 0.05);
  }
}

}  // namespace
}  // namespace tamis::bullet

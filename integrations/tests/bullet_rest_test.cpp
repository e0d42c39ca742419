// Columns, piles and walls in Bullet's clamped world come to rest and sleep; no thrown body stands in the air.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "integrations/bullet/throws/random.hpp"
#include "integrations/tests/bullet_simulation.hpp"

namespace tamis::bullet {
namespace {

constexpr btScalar kHalf = 0.1F, kGravity = 10;

/// A floor, and boxes.
class Boxes : public Simulation {
 public:
  explicit Boxes(unsigned seed) : random_(seed) { add(floor_, 0, {0, -0.5F, 0}); }

  /// Up to `off` beside the place, and turned by up to `turn` about the vertical.
  void add_box(const btVector3& place, double off, double turn) {
    const btVector3 beside = random_.vector(off) * btVector3(1, 0, 1);
    btRigidBody& body = add(box_, 1, place + beside);
    body.setCenterOfMassTransform(
        btTransform(btQuaternion({0, 1, 0}, static_cast<btScalar>(random_.between(-turn, turn))), place + beside));
  }

  double energy() const {
    double sum = 0;
    for (const auto& body : bodies) {
      if (body->isStaticObject()) continue;
      const btVector3 spin = body->getAngularVelocity() * body->getWorldTransform().getBasis();
      const btVector3 inertia(1 / body->getInvInertiaDiagLocal().x(), 1 / body->getInvInertiaDiagLocal().y(),
                              1 / body->getInvInertiaDiagLocal().z());
      sum += double{0.5F * body->getLinearVelocity().length2() + 0.5F * (inertia * spin).dot(spin) +
                    kGravity * body->getWorldTransform().getOrigin().y()};
    }
    return sum;
  }
  long awake() const {
    return std::ranges::count_if(bodies, [](const auto& body) { return !body->isStaticObject() && body->isActive(); });
  }

 private:
  Random random_;
  btBoxShape floor_{{50, 0.5F, 50}}, box_{{kHalf, kHalf, kHalf}};
};

void add_column(Boxes& boxes, int count, btScalar drop) {
  for (int i = 0; i < count; ++i)
    boxes.add_box({0, kHalf + drop + static_cast<btScalar>(i) * (2 * kHalf + drop), 0}, 0.01, 0.3);
}

/// Expects that all boxes sleep after so many steps, and that they never had more energy than at first.
void expect_rest(Boxes& boxes, int steps, const std::string& name) {
  const double first = boxes.energy();
  double most = first;
  for (int i = 0; i < steps; ++i) {
    boxes.run(1);
    ASSERT_EQ(boxes.world.last_step().overlapping, 0U) << name << ", step " << i;
    most = std::max(most, boxes.energy());
  }
  EXPECT_LT(most, 1.001 * first) << name;
  EXPECT_EQ(boxes.awake(), 0) << name;
}

TEST(Rest, ColumnsStandAndSleep) {
  for (const int count : {3, 5, 10, 25})
    for (const unsigned seed : {1U, 2U, 3U}) {
      Boxes boxes(seed);
      add_column(boxes, count, 0.01F);
      expect_rest(boxes, 360, std::to_string(count) + " boxes, seed " + std::to_string(seed));
      for (int i = 1; i <= count; ++i) {
        const btScalar above = boxes.bodies[static_cast<std::size_t>(i)]->getWorldTransform().getOrigin().y() -
                               kHalf * static_cast<btScalar>(2 * i - 1);
        EXPECT_GT(above, 0) << i;
        EXPECT_LT(above, 0.0015F * static_cast<btScalar>(i)) << i;
      }
    }
}

TEST(Rest, PilesSleep) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    Boxes boxes(seed);
    for (int i = 0; i < 50; ++i) boxes.add_box({0, 0.2F + 0.3F * static_cast<btScalar>(i), 0}, 0.2, 1);
    expect_rest(boxes, 600, "seed " + std::to_string(seed));
  }
}

TEST(Rest, WallsSleep) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    Boxes boxes(seed);
    for (int layer = 0; layer < 5; ++layer)
      for (int i = 0; i < 6; ++i) {
        const btScalar x = (static_cast<btScalar>(i) + 0.5F * static_cast<btScalar>(layer % 2)) * (2 * kHalf + 0.01F);
        boxes.add_box({x, kHalf + 0.01F + static_cast<btScalar>(layer) * (2 * kHalf + 0.01F), 0}, 0.001, 0);
      }
    expect_rest(boxes, 360, "seed " + std::to_string(seed));
  }
}

/// Bug: 34 of 100 throws stood for five steps and more, at gaps that floats cannot tell.
TEST(Rest, NoThrownBodyStands) {
  btBoxShape wall({1, 1, 0.01F}), plate({0.15F, 0.1F, 0.02F});
  for (unsigned seed = 0; seed < 40; ++seed) {
    Random random(seed);
    Simulation simulation;
    simulation.world.setGravity({0, 0, 0});
    simulation.add(wall, 0, {0, 0, 0});
    btRigidBody& body = simulation.add(plate, 1, {0.013F, 0.007F, static_cast<btScalar>(random.between(0.6, 3))});
    body.setLinearVelocity({0, 0, static_cast<btScalar>(-random.between(20, 120))});
    body.setAngularVelocity(random.vector(100));
    int stands = 0, longest = 0;
    for (int i = 0; i < 60; ++i) {
      simulation.run(1);
      for (const auto& [moved, fraction] : simulation.world.last_step().moved) {
        stands = fraction < 0.01 ? stands + 1 : 0;
        longest = std::max(longest, stands);
      }
    }
    EXPECT_LT(longest, 5) << "seed " << seed;
  }
}

}  // namespace
}  // namespace tamis::bullet

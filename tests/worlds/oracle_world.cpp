#include "worlds/oracle_world.hpp"

#include <gtest/gtest.h>

namespace tamis::test {

oracle::MovingBody for_oracle(const Shape& shape, const BodyMotion& motion) {
  const auto faces = shape.mesh().faces();
  oracle::MovingBody body{shape.points(), {faces.begin(), faces.end()}};
  const auto add = [&](const Pose& start, const Pose& end) {
    body.links.push_back({start.rotation, end.rotation, start.position, end.position});
  };
  if (const auto* still = std::get_if<Static>(&motion)) add(still->pose, still->pose);
  if (const auto* rigid = std::get_if<Rigid>(&motion))
    for (const RigidLink& link : rigid->chain) add(link.start, link.end);
  if (const auto* soft = std::get_if<Deforming>(&motion)) {
    body.points = soft->start;
    body.points_at_end = soft->end;
  }
  return body;
}

double true_first_touch(const TestWorld& world, double separation) {
  oracle::Real first = 2;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const TestBody& a = world.bodies[i];
    const oracle::MovingBody body = for_oracle(a.shape, a.motion);
    if (std::holds_alternative<Deforming>(a.motion))
      first = std::min(first, oracle::first_touch(body, separation + 2 * a.radius));
    for (std::size_t j = 0; j < i; ++j) {
      const TestBody& b = world.bodies[j];
      if (std::holds_alternative<Static>(a.motion) && std::holds_alternative<Static>(b.motion)) continue;
      first =
          std::min(first, oracle::first_touch(body, for_oracle(b.shape, b.motion), separation + a.radius + b.radius));
    }
  }
  return static_cast<double>(first);
}

bool expect_truth(TestWorld& world, double separation) {
  const double truth = true_first_touch(world, separation);
  const PathOptions asked{.min_separation = separation};
  Options with_threads;
  with_threads.threads = 3;
  TestWorld same(with_threads);
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    same.add(world.bodies[i].shape, world.bodies[i].motion);
    same.set_radius(static_cast<BodyId>(i), world.bodies[i].radius);
  }
  const EarliestBodyContact first = world.world.earliest(asked);
  expect_same_bits(first, same.world.earliest(asked));
  EXPECT_EQ(first.contact.has_value(), truth <= 1);
  EXPECT_EQ(world.world.is_free(asked), truth > 1);
  EXPECT_EQ(world.world.contacts(asked).empty(), truth > 1);
  if (truth <= 1) {
    EXPECT_LE(first.toi_lower, truth + 1e-12);
    EXPECT_GE(first.toi_upper, truth - 1e-12);
    EXPECT_GT(first.toi_lower, truth - 1e-6);
  }
  return truth <= 1;
}

}  // namespace tamis::test

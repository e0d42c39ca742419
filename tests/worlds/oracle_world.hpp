// What an oracle that shares no code with the library says of a world: tests/oracle/bodies.hpp.
#pragma once
#include "oracle/bodies.hpp"
#include "worlds/random_world.hpp"

namespace tamis::test {

/// Of triangles alone.
oracle::MovingBody for_oracle(const Shape& shape, const BodyMotion& motion);

/// When the first two bodies touch, or a deforming one itself; above 1: never.
double true_first_touch(const TestWorld& world, double separation);

/// All that a world says of its first contact agrees, whoever asks it, with this time. Returns whether there is one.
bool expect_truth(TestWorld& world, double separation = 0);

}  // namespace tamis::test

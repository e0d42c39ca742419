// Bodies that come, go, and are kept apart.
#include <gtest/gtest.h>

#include "world/random_world.hpp"

namespace tamis::test {
namespace {

TEST(World, HasNoContactsWithoutBodies) {
  World world;
  EXPECT_TRUE(world.contacts().empty());
  EXPECT_EQ(world.earliest().toi_lower, 1);
  EXPECT_TRUE(world.is_free());
  EXPECT_TRUE(world.near(1).empty());
  EXPECT_TRUE(world.intersections().empty());
  EXPECT_EQ(world.keep_distance().lower, 1);
}

}  // namespace
}  // namespace tamis::test

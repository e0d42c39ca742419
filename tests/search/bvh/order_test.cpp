// Would catch: blocks of one group each where groups lie in each other, or of two bodies that change places: such trees
// are searched in a time that grows with the square of the mesh.
#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <vector>

#include "scenes/point_math.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "search/bvh/group_order.hpp"
#include "search/bvh/order_axes.hpp"

namespace tamis::test {
namespace {

using namespace scenes;

/// Of features in a unit cube each, `apart` from one group's cube to the next.
GroupOrder order_of_groups(float apart) {
  constexpr Index kGroups = 16, kFeatures = 100;
  std::vector<std::array<float, 3>> places;
  Random random(1);
  for (Index i = 0; i < kGroups * kFeatures; ++i) {
    const Point p = random.point_between(0, 1);
    places.push_back({static_cast<float>(p[0]) + apart * static_cast<float>(i % kGroups), static_cast<float>(p[1]),
                      static_cast<float>(p[2])});
  }
  std::vector<GroupedFeature> features;
  for (Index i = 0; i < kGroups * kFeatures; ++i)
    features.push_back({i % kGroups, places[static_cast<std::size_t>(i)].data()});
  return order_groups(features, std::vector<std::uint8_t>(kGroups, 1));
}

TEST(OrderOfGroups, KeepsTogetherThoseThatAreApart) {
  const GroupOrder order = order_of_groups(1);
  ASSERT_EQ(order.features.size(), 1600u);
  EXPECT_EQ(order.ends.size(), 17u) << "none that touch themselves, and sixteen groups";
  for (std::size_t i = 0; i < 1600; ++i) EXPECT_EQ(order.features[i] % 16, order.features[i - i % 100] % 16) << i;
}

TEST(OrderOfGroups, IsEmptyWhereManyLieInEachOther) {
  EXPECT_TRUE(order_of_groups(0).features.empty());
  EXPECT_FALSE(order_of_groups(0.6F).features.empty()) << "in most places lie one or two";
}

/// Of two balls that change places along x: `times` the way from one to the other.
OrderAxes axes_of_passing_balls(double times, LooksAt looks_at) {
  Scene scene;
  for (Index body = 0; body < 2; ++body)
    add_shape(
        scene, unit_sphere(20), body,
        [&](const Point& p) {
          return p + Point{3.0 * body, 0, 0};
        },
        [&](const Point& p) {
          return p + Point{3.0 * body + times * (body == 0 ? 3 : -3), 0, 0};
        });
  std::vector<Index> points(scene.start.size());
  std::iota(points.begin(), points.end(), 0);
  PackedMotion motion;
  motion.assign(scene.step(), points, {});
  return order_axes(motion, points, looks_at);
}

TEST(OrderAxesOfPassingBodies, PartThemByTheirWays) {
  EXPECT_GT(axes_of_passing_balls(1, LooksAt::whole_step).displacement_weight, 0) << "halfway they are in one place";
  const OrderAxes for_distances = axes_of_passing_balls(1, LooksAt::distances);
  EXPECT_TRUE(for_distances.displacement_weight > 0 || for_distances.time == 0) << "at the start they are not";
  EXPECT_EQ(axes_of_passing_balls(0.01, LooksAt::whole_step).displacement_weight, 0);
}

}  // namespace
}  // namespace tamis::test

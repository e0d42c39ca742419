// The normal of a contact is a unit vector, however small or degenerate the features are.
#include <gtest/gtest.h>

#include <cmath>

#include "support/contact_sets.hpp"
#include "support/test_names.hpp"

namespace tamis::test {
namespace {

using scenes::Scene;

/// An edge of the given length falls on another, crosswise, from height 1 to -1.
Scene crossing_edges(double length) {
  Scene scene;
  const auto add = [&](const Point& from, double fall) {
    return scene.add_vertex(from, {from[0], from[1], from[2] - fall}, 0);
  };
  const Index a = add({-length, 0, 0}, 0), b = add({length, 0, 0}, 0);
  const Index c = add({0, -length, 1}, 2), d = add({0, length, 1}, 2);
  scene.loose_edges = {{a, b}, {c, d}};
  return scene;
}

/// The same with a face instead of the lower edge.
Scene point_on_face(double size) {
  Scene scene;
  for (const Point& p : {Point{-size, -size, 0}, Point{size, -size, 0}, Point{0, size, 0}}) scene.add_vertex(p, p, 0);
  scene.faces.push_back({0, 1, 2});
  scene.loose_points.push_back(scene.add_vertex({0, 0, 1}, {0, 0, -1}, 0));
  return scene;
}

class Normal : public testing::TestWithParam<Method> {};

// Bug: a square underflows, and the length it is divided by is zero.
TEST_P(Normal, IsAUnitVectorHoweverSmallTheFeatures) {
  Options options;
  options.method = GetParam();
  for (const double size : {1.0, 1e-60, 1e-90, 1e-120, 1e-170, 1e-300})
    for (const Scene& scene : {crossing_edges(size), point_on_face(size)}) {
      const auto contacts = find_contacts(scene, options);
      ASSERT_EQ(contacts.size(), 1u) << size;
      EXPECT_NEAR(std::fabs(contacts[0].normal[2]), 1, 1e-12) << size;
    }
}

TEST_P(Normal, IsAUnitVectorWhereAFeatureIsAPoint) {
  Options options;
  options.method = GetParam();
  Scene scene = crossing_edges(5e-324);
  scene.start[2] = scene.start[3];
  scene.end[2] = scene.end[3];
  scene.start[0] = scene.end[0] = scene.start[1] = scene.end[1] = {0, 5e-324, 0};
  const auto contacts = find_contacts(scene, options);
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_NEAR(std::hypot(contacts[0].normal[0], contacts[0].normal[1], contacts[0].normal[2]), 1, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Methods, Normal, testing::ValuesIn(kMethods),
                         [](const testing::TestParamInfo<Method>& method) { return test_name(name_of(method.param)); });

}  // namespace
}  // namespace tamis::test

// The ends of the step: a pair that touches exactly at t=0 or t=1 is a contact; one that would touch just before or
// after the step is none.
#include <gtest/gtest.h>

#include "support/contact_sets.hpp"
#include "support/test_names.hpp"
#include "support/yardstick/methods.hpp"

namespace tamis::test {
namespace {

using scenes::Scene;

/// A vertex over the inside of a resting face, at `from` at t=0 and at `to` at t=1.
Scene falling_point(double from, double to) {
  Scene scene;
  for (const Point& p : {Point{0, 0, 0}, Point{1, 0, 0}, Point{0, 1, 0}}) scene.add_vertex(p, p, 0);
  scene.faces.push_back({0, 1, 2});
  scene.loose_points.push_back(scene.add_vertex({0.25, 0.25, from}, {0.25, 0.25, to}, 1));
  return scene;
}

class StepEnds : public testing::TestWithParam<Method> {
 protected:
  std::vector<Contact> contacts(const Scene& scene) const {
    yardstick::Options options;
    options.method = GetParam();
    return find_contacts(scene, options);
  }
};

// Catches a hierarchy that rounds the end of the step up, so that the solver reports contacts beyond it.
TEST_P(StepEnds, ContactsBeyondTheStepAreNone) {
  for (const double just : {1e-6, 1e-7, 3e-8, 1e-8, 1e-10, 1e-12}) {
    EXPECT_TRUE(contacts(falling_point(1, just)).empty()) << "after the end, " << just;
    EXPECT_TRUE(contacts(falling_point(just, 1)).empty()) << "before the start, " << just;
  }
}

TEST_P(StepEnds, ContactsAtTheEndsAreFoundWithTimesInsideTheStep) {
  for (const double just : {0.0, -1e-16, -1e-12, -1e-7}) {
    for (const Scene& scene : {falling_point(1, just), falling_point(just, 1)}) {
      const auto found = contacts(scene);
      ASSERT_EQ(found.size(), 1u) << just;
      EXPECT_LE(0, found[0].toi_lower);
      EXPECT_LE(found[0].toi_lower, found[0].toi_upper);
      EXPECT_LE(found[0].toi_upper, 1);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, StepEnds, testing::ValuesIn(kMethods),
                         [](const testing::TestParamInfo<Method>& parameter) {
                           return test_name(name_of(parameter.param));
                         });

}  // namespace
}  // namespace tamis::test

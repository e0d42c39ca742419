// Truncated steps: on the straight way to the returned positions, every pair keeps the part of its distance that was
// asked for (checked for each pair by itself, at many times); and one pair does not stop the others.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "api/truncate/truncated.hpp"
#include "scenes/scene_list.hpp"
#include "support/contact_sets.hpp"
#include "support/test_names.hpp"
#include "support/yardstick/methods.hpp"
#include "tamis/detector.hpp"

namespace tamis::test {
namespace {

class TruncateScene : public testing::TestWithParam<scenes::Recipe> {};

// Bugs: a pair without a plane; one that keeps its part until the end of the common step, and only an eighth of that
// afterwards; a bound that holds on the planned way but not on the straight one; a position that is rounded nearer.
TEST_P(TruncateScene, EveryPairKeepsTheFractionOfItsDistance) {
  for (std::uint64_t seed = 0; seed < 2; ++seed)
    for (const double separation : {0.0, 0x1p-7})
      for (const double fraction : {0x1p-20, 0.1, 0.5, 0.9}) {
        const Scene scene = GetParam().make(40 + 60 * static_cast<Index>(seed), 15 + seed);
        SCOPED_TRACE(scene.name + ", seed " + std::to_string(seed) + ", fraction " + std::to_string(fraction));
        Detector detector = yardstick::make_detector(scene.mesh(), with(Method::tamis, separation));
        const TruncatedStep to = detector.truncate(scene.step(), fraction);
        expect_kept(scene, to.positions, fraction, separation);
        EXPECT_EQ(to.is_free, detector.is_free({scene.start, scene.start}));
        if (to.is_free) {
          EXPECT_TRUE(detector.is_free({scene.start, to.positions}));
        }
        if (detector.safe_step(scene.step(), std::min(1.25 * fraction, fraction + 0.25 * (1 - fraction))).toi_lower ==
            1) {
          EXPECT_EQ(to.positions, scene.end);
        }
      }
}

TEST_P(TruncateScene, MethodsAgreeAndPartsSayWherePositionsAre) {
  const Scene scene = GetParam().make(60, 5);
  const TruncatedStep to = yardstick::make_detector(scene.mesh(), with(Method::tamis, 0)).truncate(scene.step());
  const TruncatedStep other = yardstick::make_detector(scene.mesh(), with(Method::brute, 0)).truncate(scene.step());
  EXPECT_EQ(other.positions, to.positions);
  EXPECT_EQ(other.fractions, to.fractions);
  EXPECT_EQ(other.is_free, to.is_free);
  for (std::size_t v = 0; v < to.fractions.size(); ++v)
    for (std::size_t k = 0; k < 3; ++k) {
      const double from = scene.start[v][k], until = scene.end[v][k];
      EXPECT_NEAR(to.positions[v][k], from + to.fractions[v] * (until - from),
                  0x1p-50 * std::max(std::fabs(from), std::fabs(until)));
    }
}

// Bug: among the largest doubles, sums of products overflow though their result would not.
TEST_P(TruncateScene, IsFreeAmongTheLargestDoubles) {
  Scene scene = GetParam().make(100, 7);
  double largest = 0;
  for (const auto* points : {&scene.start, &scene.end})
    for (const Point& p : *points)
      for (const double x : p) largest = std::max(largest, std::fabs(x));
  int exponent = 0;
  std::frexp(largest, &exponent);
  for (auto* points : {&scene.start, &scene.end})
    for (Point& p : *points)
      for (double& x : p) x = std::ldexp(x, 1024 - exponent);
  Detector detector(scene.mesh());
  const TruncatedStep to = detector.truncate(scene.step());
  EXPECT_EQ(to.is_free, detector.is_free({scene.start, scene.start}));
  EXPECT_TRUE(!to.is_free || detector.is_free({scene.start, to.positions}));
}

INSTANTIATE_TEST_SUITE_P(Scenes, TruncateScene, testing::ValuesIn(scenes::recipes().begin(), scenes::recipes().end()),
                         scene_test_name);

}  // namespace
}  // namespace tamis::test

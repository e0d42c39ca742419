// safe_step for scenes with known answers: how far the step may go so that every pair keeps a fraction of its distance.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "support/contact_sets.hpp"
#include "support/step_lengths.hpp"
#include "support/test_names.hpp"
#include "support/yardstick/methods.hpp"
#include "tamis/error.hpp"

namespace tamis::test {
namespace {

using scenes::Scene;

/// A point over a resting face, at height `from` at t=0 and `to` at t=1, `far` from the origin.
Scene falling_point(double from, double to, double far = 0) {
  Scene scene;
  for (const Point& p : {Point{far, 0, 0}, Point{far + 1, 0, 0}, Point{far, 1, 0}}) scene.add_vertex(p, p, 0);
  scene.faces.push_back({0, 1, 2});
  scene.loose_points.push_back(scene.add_vertex({far + 0.25, 0.25, from}, {far + 0.25, 0.25, to}, 1));
  return scene;
}

class KnownStep : public testing::TestWithParam<Method> {};

TEST_P(KnownStep, FallsUntilTheFractionIsLeft) {
  for (const double far : {0.0, 1e6})
    for (const double fraction : {0.0, 0.1, 0.5, 0.9, 0.999}) {
      const SafeStep safe = keep(falling_point(1, -1, far), fraction, with(GetParam()));
      const double truth = 0.5 * (1 - fraction);
      EXPECT_LE(safe.toi_lower, truth * (1 + 1e-12));
      EXPECT_LE(truth * (1 - 1e-12), safe.toi_upper);
      EXPECT_LE(safe.toi_upper - safe.toi_lower, 1e-9);
      ASSERT_TRUE(safe.pair);
      EXPECT_EQ(safe.pair->vertices, (std::array<Index, 4>{3, 0, 1, 2}));
      EXPECT_EQ(safe.pair->distance, 1);
      EXPECT_EQ(safe.pair->direction, (Point{0, 0, 1}));
    }
}

TEST_P(KnownStep, CountsTheDistanceBeyondTheMinimumSeparation) {
  const SafeStep safe = keep(falling_point(1, -1), 0.5, with(GetParam(), 0.5));
  EXPECT_NEAR(safe.toi_lower, 0.125, 1e-9);
  EXPECT_LE(safe.toi_lower, 0.125);
  EXPECT_EQ(keep(falling_point(1, -1), 0.5, with(GetParam(), 1)).toi_lower, 0) << "within it at t=0";
  EXPECT_GT(keep(falling_point(1, -1), 0.5, with(GetParam(), std::nextafter(1.0, 0.0))).toi_lower, 0);
}

/// Adds a triangle that turns by `angle` about an axis along z through its middle, and moves by `way`.
void add_turning(Scene& scene, const std::array<Point, 3>& corners, double angle, const Point& way) {
  const double c = std::cos(angle), s = std::sin(angle);
  const auto mean = [&](std::size_t k) { return (corners[0][k] + corners[1][k] + corners[2][k]) / 3; };
  const Index at = scene.vertex_count();
  for (const Point& p : corners) {
    const double x = p[0] - mean(0), y = p[1] - mean(1);
    scene.add_vertex(p, {mean(0) + c * x - s * y + way[0], mean(1) + s * x + c * y + way[1], p[2] + way[2]}, 0);
  }
  scene.faces.push_back({at, at + 1, at + 2});
}

// Bug: a scene that shrinks as a whole seems to keep its distances, though the separation does not shrink with it.
TEST_P(KnownStep, ShrinksAsAWholeUntilItIsWithinTheSeparation) {
  Scene scene;
  for (const double height : {0.0, 1.0})
    add_turning(scene, {{{0, 0, height}, {0.01, 0, height}, {0, 0.01, height}}}, 0.5, {0, 0, -0.5 * height});
  const SafeStep safe = keep(scene, 0.25, with(GetParam(), 0.8));
  EXPECT_NEAR(safe.toi_lower, (1 - 0.8 - 0.25 * 0.2) / 0.5, 1e-3);
  EXPECT_TRUE(safe.pair);
}

// Bug: two objects that keep their shapes seem to keep their distance.
TEST_P(KnownStep, ObjectsThatTurnByThemselvesMeet) {
  Scene scene;
  add_turning(scene, {{{-1, 0, 0}, {1, 0, 0}, {0, 0.01, 0}}}, 1, {0, 0, 0});
  add_turning(scene, {{{0.7, 0.4, 0}, {0.71, 0.4, 0.01}, {0.7, 0.41, 0}}}, -1, {0, 0, 0});
  const SafeStep safe = keep(scene, 0.25, with(GetParam()));
  EXPECT_GT(safe.toi_lower, 0.3);
  EXPECT_LT(safe.toi_lower, 0.6);  // two thirds of the way to tan(angle) = 0.4 / 0.7
}

TEST_P(KnownStep, GoesAllTheWayAtRestAndAway) {
  for (const double end : {0.25, 1.0})
    for (const double fraction : {0.0, 0.5, 0.999}) {
      const SafeStep safe = keep(falling_point(0.25, end), fraction, with(GetParam()));
      EXPECT_EQ(safe.toi_lower, 1);
      EXPECT_EQ(safe.toi_upper, 1);
      EXPECT_FALSE(safe.pair);
    }
}

// Bug: an optimizer is stopped for ever because doubles cannot tell touching from nearly touching.
TEST_P(KnownStep, IsZeroOnlyIfTheyTouchAtTheStart) {
  for (const double fraction : {0.0, 0.5, 1 - 0x1p-53}) {
    const SafeStep touching = keep(falling_point(0, -1), fraction, with(GetParam()));
    EXPECT_EQ(touching.toi_lower, 0);
    EXPECT_EQ(touching.toi_upper, 0);
    EXPECT_TRUE(touching.pair);
    for (const double height : {0x1p-1000, 0x1p-500, 1e-20, 1e-9})
      EXPECT_GT(keep(falling_point(height, -1), fraction, with(GetParam())).toi_lower, 0) << height << " " << fraction;
    for (const double height : {1e-9, 1e-15})
      EXPECT_EQ(keep(falling_point(height, height), fraction, with(GetParam())).toi_lower, 1)
          << height << " " << fraction;
  }
}

TEST_P(KnownStep, FacesOfNoAreaKeepTheirDistanceToo) {
  Scene scene = falling_point(1, -1);
  scene.start[2] = scene.end[2] = {0.5, 0, 0};  // on the line of the other two
  scene.start[3] = {0.25, 0, 1};
  scene.end[3] = {0.25, 0, -1};
  EXPECT_NEAR(keep(scene, 0.5, with(GetParam())).toi_lower, 0.25, 1e-9);
}

TEST_P(KnownStep, FiltersLeaveOutPairs) {
  const Scene scene = falling_point(1, -1);
  yardstick::Options options = with(GetParam());
  options.filter.accepts = [](PairKind, const std::array<Index, 4>&) { return false; };
  for (const double fraction : {0.0, 0.5}) EXPECT_EQ(keep(scene, fraction, options).toi_lower, 1);
}

TEST_P(KnownStep, RefusesFractionsThatAreNone) {
  for (const double fraction : {-0.1, 1.0, 2.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(keep(falling_point(1, -1), fraction, with(GetParam())), InvalidOptions) << fraction;
}

// Bug: two triangles whose differences overflow pass through each other.
TEST_P(KnownStep, StopsAtTheEndOfTheRangeOfDoubles) {
  Scene scene;
  const auto add = [&](const std::array<Point, 3>& corners, double fall) {
    Face face;
    for (std::size_t i = 0; i < 3; ++i) {
      Point start, end;
      for (std::size_t k = 0; k < 3; ++k) {
        start[k] = std::ldexp(corners[i][k], 1023);
        end[k] = std::ldexp(corners[i][k] - (k == 2 ? fall : 0), 1023);
      }
      face[i] = scene.add_vertex(start, end, 0);
    }
    scene.faces.push_back(face);
  };
  add({{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}}, 0);
  add({{{0, 0, 0.5}, {0.1, 0, 1}, {-0.1, 0.1, 1}}}, 1);
  for (const double fraction : {0.0, 0.2, 0.9}) {
    const SafeStep safe = keep(scene, fraction, with(GetParam()));
    EXPECT_NEAR(safe.toi_lower, 0.5 * (1 - fraction), 1e-12);
    EXPECT_NEAR(safe.toi_upper, 0.5 * (1 - fraction), 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, KnownStep, testing::ValuesIn(kMethods),
                         [](const testing::TestParamInfo<Method>& method) { return test_name(name_of(method.param)); });

/// A hub at rest, and a rim that begins to wave. `faces`: slivers from the hub to the rim; else spokes and rim edges.
Scene waving_fan(Index slivers, bool faces) {
  Scene scene;
  const Index hub = scene.add_vertex({0, 0, 0}, {0, 0, 0}, 0);
  for (Index i = 0; i < slivers; ++i) {
    const double angle = 2 * std::numbers::pi * i / slivers;
    const Point p{std::cos(angle), std::sin(angle), 0};
    scene.add_vertex(p, {p[0], p[1], 0.1 * std::sin(7 * angle)}, 0);
  }
  for (Index i = 0; i < slivers; ++i) {
    const Index from = 1 + i, to = 1 + (i + 1) % slivers;
    if (faces)
      scene.faces.push_back({hub, from, to});
    else
      scene.loose_edges.insert(scene.loose_edges.end(), {{hub, from}, {from, to}});
  }
  return scene;
}

std::uint64_t last_stage(const Statistics& statistics) {
  const StageCount& last = statistics.stages.back();
  return last.vf + last.ee + last.ve + last.vv;
}

// Bug: long slivers that are near each other for their length were decided one by one, tens for each sliver, and more
// the finer the fan.
TEST(SafeStep, DecidesHardlyAnyPairOfAFanSingly) {
  for (const bool faces : {true, false}) {
    const Scene scene = waving_fan(4000, faces);
    const Mesh mesh = scene.mesh();
    for (const double fraction : {0.1, 0.5}) {
      Detector detector(mesh);
      EXPECT_EQ(detector.safe_step(scene.step(), fraction).toi_lower, 1);
      EXPECT_LT(last_stage(detector.statistics()), 400u) << faces << ' ' << fraction;
      (void)detector.truncate(scene.step(), fraction);
      EXPECT_LT(last_stage(detector.statistics()), 400u) << faces << ' ' << fraction;
    }
  }
}

}  // namespace
}  // namespace tamis::test

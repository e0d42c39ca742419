// Where a step may end: of every pair, looked at by itself at many times of the straight way to the very positions, as
// much of its distance is left as was asked for; and one pair does not stop the rest.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "lab/detector.hpp"
#include "lab/pairs.hpp"
#include "support/contact_sets.hpp"
#include "support/test_names.hpp"
#include "tamis/detector.hpp"
#include "tamis/error.hpp"
#include "tamis/pair_distance.hpp"

namespace tamis::test {
namespace {

using scenes::Recipe, scenes::Scene;

std::vector<Point> at_time(const std::vector<Point>& from, const std::vector<Point>& to, double t) {
  std::vector<Point> points = from;
  for (std::size_t v = 0; v < points.size(); ++v)
    for (std::size_t k = 0; k < 3; ++k) points[v][k] = (1 - t) * from[v][k] + t * to[v][k];
  return points;
}

/// The largest coordinate of a pair's vertices: the unit of what rounding takes from a distance.
double size_of(const std::vector<Point>& points, const PairVertices& vertices) {
  double size = 0;
  for (const Index v : vertices)
    if (v >= 0)
      for (const double x : points[static_cast<std::size_t>(v)]) size = std::max(size, std::fabs(x));
  return size;
}

/// Of every pair of the scene.
void expect_kept(const Scene& scene, const std::vector<Point>& to, double fraction, double separation) {
  std::vector<std::vector<Point>> ways;
  for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) ways.push_back(at_time(scene.start, to, t));
  lab::for_each_pair(scene.mesh(), {}, [&](PairKind kind, const PairVertices& v) {
    const double before = distance_of({kind, v}, scene.start).distance;
    const double rounding = 0x1p-48 * std::max(size_of(scene.start, v), size_of(to, v));
    const bool starts_apart = before > separation;
    const double kept = starts_apart ? separation + fraction * (before - separation) : before * (1 - 0x1p-20);
    for (const auto& way : ways)
      ASSERT_GE(distance_of({kind, v}, way).distance, kept - rounding)
          << name_of(kind) << ' ' << v[0] << ' ' << v[1] << ' ' << v[2] << ' ' << v[3] << ", at the start " << before;
  });
}

lab::Options with(Method method, double separation) {
  lab::Options options;
  options.method = method;
  options.min_separation = separation;
  return options;
}

class TruncateScene : public testing::TestWithParam<Recipe> {};

// Bugs: a pair without a plane; one that keeps its part until all have gone together, and an eighth of that after; a
// bound that holds on the way that was planned and not on the straight one; a position rounded nearer.
TEST_P(TruncateScene, EveryPairKeepsTheFractionOfItsDistance) {
  for (std::uint64_t seed = 0; seed < 2; ++seed)
    for (const double separation : {0.0, 0x1p-7})
      for (const double fraction : {0x1p-20, 0.1, 0.5, 0.9}) {
        const Scene scene = GetParam().make(40 + 60 * static_cast<Index>(seed), 15 + seed);
        SCOPED_TRACE(scene.name + ", seed " + std::to_string(seed) + ", fraction " + std::to_string(fraction));
        Detector detector = lab::make_detector(scene.mesh(), with(Method::tamis, separation));
        const TruncatedStep to = detector.truncate(scene.step(), fraction);
        expect_kept(scene, to.positions, fraction, separation);
        EXPECT_EQ(to.is_free, detector.is_free({scene.start, scene.start}));
        if (to.is_free) {
          EXPECT_TRUE(detector.is_free({scene.start, to.positions}));
        }
        if (detector.safe_step(scene.step(), std::min(1.25 * fraction, fraction + 0.25 * (1 - fraction))).lower == 1) {
          EXPECT_EQ(to.positions, scene.end);
        }
      }
}

TEST_P(TruncateScene, MethodsAgreeAndPartsSayWherePositionsAre) {
  const Scene scene = GetParam().make(60, 5);
  const TruncatedStep to = lab::make_detector(scene.mesh(), with(Method::tamis, 0)).truncate(scene.step());
  for (const Method method : {Method::brute, Method::paper}) {
    const TruncatedStep other = lab::make_detector(scene.mesh(), with(method, 0)).truncate(scene.step());
    EXPECT_EQ(other.positions, to.positions) << name_of(method);
    EXPECT_EQ(other.parts, to.parts);
    EXPECT_EQ(other.is_free, to.is_free);
  }
  for (std::size_t v = 0; v < to.parts.size(); ++v)
    for (std::size_t k = 0; k < 3; ++k) {
      const double from = scene.start[v][k], until = scene.end[v][k];
      EXPECT_NEAR(to.positions[v][k], from + to.parts[v] * (until - from),
                  0x1p-50 * std::max(std::fabs(from), std::fabs(until)));
    }
}

// There sums of products overflow on their way, though the result would not.
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

/// A point falls on a triangle from height `above`, by `fall`; ten aside another does, that ends before it.
Scene two_falls(double above, double fall, const Point& place = {0, 0, 0}, double size = 1) {
  Scene scene;
  const auto add = [&](double x, double y, double z, double down, Index group) {
    const Point at{place[0] + size * x, place[1] + size * y, place[2] + z};
    return scene.add_vertex(at, {at[0], at[1], at[2] - down}, group);
  };
  for (const double x : {0.0, 10.0}) {
    const Index v = add(x, 0, 0, 0, 0);
    add(x + 1, 0, 0, 0, 0);
    add(x, 1, 0, 0, 0);
    scene.faces.push_back({v, v + 1, v + 2});
    scene.loose_points.push_back(x == 0 ? add(x + 0.25, 0.25, above, fall, 1) : add(x + 0.25, 0.25, 0.9, 0.1, 1));
  }
  return scene;
}

// Bug: one near pair stops the whole mesh.
TEST(Truncate, ANearPairDoesNotStopTheOthers) {
  const Scene scene = two_falls(0.5, 1);
  const TruncatedStep to = Detector(scene.mesh()).truncate(scene.step(), 0.1);
  EXPECT_TRUE(to.is_free);
  EXPECT_EQ(to.positions[7], scene.end[7]);
  EXPECT_EQ(to.positions[0], scene.end[0]);
  EXPECT_GE(to.positions[3][2], 0.05);
  EXPECT_LT(to.positions[3][2], 0.06);
}

// Bug, once: 30 of 234 such points touched where they were to go, or were 8e-10 within the separation; those positions
// had been rounded, and there was no room for that.
TEST(Truncate, LeavesRoomForRoundingHoweverLittleThereIs) {
  int moved = 0;
  for (const double far : {0.0, 1.0, 1000.0, 8e6})
    for (const double separation : {0.0, 0x1p-10})
      for (const double size : {1.0, 0.3, 1e-3})
        for (int ulps = 1; ulps <= 10; ++ulps) {
          const double surface = far / 3;  // no round number
          const double ulp = std::nextafter(surface + separation, HUGE_VAL) - (surface + separation);
          Scene scene = two_falls(separation + ulps * ulp, 0.7, {far, -far, surface}, size);
          Detector detector = lab::make_detector(scene.mesh(), with(Method::tamis, separation));
          if (!detector.is_free({scene.start, scene.start})) continue;  // rounded together
          const TruncatedStep to = detector.truncate(scene.step());
          SCOPED_TRACE(testing::Message() << ulps << " ulps above, at " << far << ", separation " << separation);
          EXPECT_TRUE(to.is_free);
          EXPECT_TRUE(detector.is_free({scene.start, to.positions}));
          EXPECT_TRUE(detector.is_free({to.positions, to.positions}));
          expect_kept(scene, to.positions, 0.1, separation);
          EXPECT_LT(to.positions[7][2], scene.start[7][2]) << "the other one";
          moved += to.positions[3] != scene.start[3];
        }
  EXPECT_GT(moved, 50);
}

// Bug: no reach where the square of a length is infinite. The face slides within its plane until it meets a point.
TEST(Truncate, AVertexDoesNotPassAFaceThatIsFast) {
  for (const double away : {1e3, 1e150, 4e159, 1e300}) {
    const Mesh mesh(5, {{0, 1, 2}}, {}, {3, 4});
    const std::vector<Point> start{{-1, -1, 0}, {2, -1, 0}, {-1, 2, 0}, {0.7, 0, 0.5}, {2.5, 0, 0}};
    std::vector<Point> end = start;
    for (std::size_t v = 0; v < 3; ++v) end[v][0] += away;
    end[3][2] = -0.5;
    Detector detector(mesh);
    const TruncatedStep to = detector.truncate({start, end}, 0.1);
    EXPECT_LT(to.parts[3], 0.5) << away;
    EXPECT_TRUE(detector.is_free({start, to.positions})) << away;
  }
}

// Bug, once: nothing moved at all, and nine searches found the same contact.
TEST(Truncate, WhatTouchesAtTheStartStaysAndIsAskedAboutOnce) {
  const Scene scene = two_falls(0, 1);
  lab::Options options;
  std::atomic<int> asked = 0;
  options.filter.accepts = [&](PairKind kind, const std::array<Index, 4>& v) {
    asked += kind == PairKind::vertex_face && v[0] == 3 && v[1] == 0;
    return true;
  };
  Detector detector = lab::make_detector(scene.mesh(), options);
  const TruncatedStep to = detector.truncate(scene.step());
  EXPECT_FALSE(to.is_free);
  EXPECT_EQ(to.positions[3], scene.start[3]);
  EXPECT_EQ(to.parts[3], 0);
  EXPECT_EQ(to.positions[7], scene.end[7]);
  EXPECT_LE(asked, 4) << "how far together, what is within reach, and whether it holds; once more where it does not";
}

// Bug, once: a pair within the separation froze every vertex, also one that leaves.
TEST(Truncate, WhatStartsWithinTheSeparationMayLeaveButNotComeNearer) {
  constexpr double kSeparation = 0x1p-4;
  for (const double fall : {-0.05, 1.0}) {
    const Scene scene = two_falls(0.5 * kSeparation, fall);
    const TruncatedStep to = lab::make_detector(scene.mesh(), with(Method::tamis, kSeparation)).truncate(scene.step());
    EXPECT_FALSE(to.is_free);
    expect_kept(scene, to.positions, 0.1, kSeparation);
    EXPECT_EQ(to.positions[7], scene.end[7]);
    EXPECT_EQ(to.positions[3], fall < 0 ? scene.end[3] : scene.start[3]);
  }
}

std::vector<Point> as_floats(std::vector<Point> points) {
  for (Point& p : points)
    for (double& x : p) x = static_cast<float>(x);
  return points;
}

void expect_proven_floats(Detector& detector, const Scene& scene, const TruncatedStep& to) {
  EXPECT_EQ(to.positions, as_floats(to.positions));
  EXPECT_EQ(to.is_free, detector.is_free({scene.start, scene.start}));
  EXPECT_EQ(to.is_free, detector.is_free({scene.start, to.positions}));
}

// Bug: positions are proven as doubles and stored as floats, which are others. Moved far away, floats lie half a unit
// apart there, and scenes of some units are flattened onto few of them.
TEST_P(TruncateScene, FloatsAreProvenAsTheyAreStored) {
  for (const double away : {1e3, 8e6})
    for (const double separation : {0.0, 0x1p-7}) {
      Scene scene = GetParam().make(40, 3);
      for (auto* points : {&scene.start, &scene.end})
        for (Point& p : *points) p = {100 * p[0] + away, 100 * p[1] - away, 100 * p[2] + away};
      scene.start = as_floats(scene.start);
      SCOPED_TRACE(testing::Message() << scene.name << " at " << away << ", separation " << separation);
      Detector detector = lab::make_detector(scene.mesh(), with(Method::tamis, separation));
      const TruncatedStep to = detector.truncate(scene.step(), 0.1, {}, Stored::float32);
      expect_proven_floats(detector, scene, to);
      expect_kept(scene, to.positions, 0.1, separation);
      scene.end = as_floats(scene.end);
      EXPECT_EQ(detector.truncate(scene.step(), 0.1, {}, Stored::float32).positions, to.positions);
    }
}

// Bug: planes without room for rounding: where the gap is of some floats, both are rounded across them and stay.
TEST(Truncate, LeavesRoomForFloatsHoweverLittleThereIs) {
  int moved = 0, places = 0;
  for (const float far : {0.0F, 1.0F, 1000.0F, 8e6F})
    for (const double separation : {0.0, 0x1p-10})
      for (int ulps = 1; ulps <= 40; ulps += 3) {
        const float surface = far / 3, above = std::nextafter(surface + static_cast<float>(separation), HUGE_VALF);
        const double ulp = static_cast<double>(above) - (surface + static_cast<float>(separation));
        Scene scene = two_falls(separation + ulps * ulp, 0.7, {far, -far, surface}, far > 1e6F ? 8 : 1);
        scene.start = as_floats(scene.start);
        Detector detector = lab::make_detector(scene.mesh(), with(Method::tamis, separation));
        if (!detector.is_free({scene.start, scene.start})) continue;  // rounded together
        const TruncatedStep to = detector.truncate(scene.step(), 0.1, {}, Stored::float32);
        SCOPED_TRACE(testing::Message() << ulps << " ulps above, at " << far << ", separation " << separation);
        EXPECT_TRUE(to.is_free);
        expect_proven_floats(detector, scene, to);
        expect_kept(scene, to.positions, 0.1, separation);
        ++places;
        moved += to.positions[3] != scene.start[3];
      }
  EXPECT_GT(places, 60);
  EXPECT_GT(moved, places * 2 / 3);
}

// Bug: an end that is no float is reached in doubles, where the whole step is free, and stored somewhere else.
TEST(Truncate, TheWholeStepEndsAtFloatsToo) {
  Scene scene = two_falls(1, 0.1);
  scene.start = as_floats(scene.start);
  const TruncatedStep to = Detector(scene.mesh()).truncate(scene.step(), 0.1, {}, Stored::float32);
  EXPECT_EQ(to.positions, as_floats(scene.end));
  EXPECT_NE(to.positions, scene.end);
  EXPECT_EQ(to.parts, std::vector<double>(scene.start.size(), 1.0));
}

/// What is said of a step.
std::string refusal(const Scene& scene) {
  try {
    Detector(scene.mesh()).truncate(scene.step(), 0.1, {}, Stored::float32);
  } catch (const InvalidStep& error) {
    return error.what();
  }
  return "";
}

TEST(Truncate, RefusesAStartThatIsNoFloatAndAnEndBeyondAll) {
  Scene scene = two_falls(1, 0.1);
  scene.start = as_floats(scene.start);
  scene.start[3][2] = 0.1;
  EXPECT_NE(refusal(scene).find("vertex 3 at the start of the step has the coordinate 0.1, which is no float32"),
            std::string::npos)
      << refusal(scene);
  scene.start[3][2] = 1;
  scene.end[1][0] = 1e39;
  EXPECT_NE(refusal(scene).find("vertex 1 at the end of the step"), std::string::npos) << refusal(scene);
  scene.end[1][0] = 1;
  EXPECT_EQ(refusal(scene), "");
}

/// Triangles above each other, a hundredth apart, that fall by half on one that stays; one touches that, or not.
Scene stack(int layers, bool touches) {
  Scene scene;
  for (int layer = 0; layer < layers; ++layer) {
    const double z = 0.01 * layer, fall = layer > 0 ? 0.5 : 0;
    const Index v = scene.vertex_count();
    for (const Point& p : {Point{0, 0, z}, Point{1, 0, z}, Point{0, 1, z}})
      scene.add_vertex(p, {p[0], p[1], p[2] - fall}, layer);
    scene.faces.push_back({v, v + 1, v + 2});
  }
  if (touches) scene.loose_points.push_back(scene.add_vertex({0.9, 0.09, 0}, {0.9, 0.09, -1}, layers));
  return scene;
}

// Bug: each layer stops a round after the one below it; when rounds end, all go back to where all go together, which is
// the start if anything touches.
TEST(Truncate, AStackSettlesHoweverHighItIs) {
  for (const int layers : {10, 80})
    for (const bool touches : {false, true}) {
      const Scene scene = stack(layers, touches);
      const TruncatedStep to = Detector(scene.mesh()).truncate(scene.step(), 0.1);
      EXPECT_EQ(to.is_free, !touches);
      expect_kept(scene, to.positions, 0.1, 0);
      for (std::size_t v = 3; v < 3 * static_cast<std::size_t>(layers); ++v)
        EXPECT_GT(to.parts[v], 0) << "layer " << v / 3 << " of " << layers;
    }
}

// Bug: a mesh without edges has no length to measure reach by, and stays.
TEST(Truncate, PointsAloneGoTheirWay) {
  const std::vector<Point> start{{0, 0, 0}, {1, 0, 0}, {0, 5, 0}}, end{{2, 0, 0}, {-1, 0, 0}, {0, 9, 0}};
  const TruncatedStep to = Detector(Mesh(3, {}, {}, {0, 1, 2})).truncate({start, end}, 0.1);
  EXPECT_TRUE(to.is_free);
  EXPECT_EQ(to.positions[2], end[2]);
  EXPECT_GE(to.positions[1][0] - to.positions[0][0], 0.1);
  EXPECT_LT(to.positions[1][0] - to.positions[0][0], 0.2);
}

// Bug: the pairs that `pairs_within` has found are those of the search for planes.
TEST(Truncate, LeavesOtherAnswersAlone) {
  const Scene scene = two_falls(0.5, 1);
  Detector detector(scene.mesh());
  const auto& near = detector.pairs_within(scene.start, 0.6);
  const auto before = near;
  ASSERT_EQ(before.size(), 1u);
  detector.truncate(scene.step());
  ASSERT_EQ(near.size(), 1u);
  EXPECT_EQ(near[0].vertices, before[0].vertices);
}

TEST(Truncate, RefusesFractionsThatAreNone) {
  const Scene scene = two_falls(0.5, 1);
  Detector detector(scene.mesh());
  for (const double fraction : {0.0, -0.1, 1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(detector.truncate(scene.step(), fraction), InvalidOptions) << fraction;
  EXPECT_THROW(detector.truncate(scene.step(), 0.1, {.min_separation = -1.0}), InvalidOptions);
}

}  // namespace
}  // namespace tamis::test

// How far the step may go so that every pair keeps a fraction of its distance: the methods against each other, against
// distances sampled in time, and on steps whose answer is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engines/pair_rules.hpp"
#include "solve/kept_distance.hpp"
#include "support/contact_sets.hpp"
#include "support/test_names.hpp"
#include "tamis/components.hpp"
#include "tamis/detector.hpp"
#include "tamis/error.hpp"

namespace tamis::test {
namespace {

using scenes::Recipe, scenes::Scene;

SafeStep keep(const Scene& scene, double fraction, const Options& options = {}) {
  return Detector(scene.mesh(), options).keep_distance(scene.step(), fraction);
}

Options with(Method method, double min_separation = 0) {
  Options options;
  options.method = method;
  options.min_separation = min_separation;
  return options;
}

void expect_same(const SafeStep& a, const SafeStep& b, const std::string& where) {
  EXPECT_EQ(a.lower, b.lower) << where;
  EXPECT_EQ(a.upper, b.upper) << where;
  ASSERT_EQ(a.pair.has_value(), b.pair.has_value()) << where;
  if (!a.pair) return;
  EXPECT_EQ(a.pair->kind, b.pair->kind) << where;
  EXPECT_EQ(a.pair->vertices, b.pair->vertices) << where;
  EXPECT_EQ(a.pair->distance, b.pair->distance) << where;
}

/// Each point a part of the way between its two ends.
std::vector<Point> between(const Scene& scene, double t) {
  std::vector<Point> points = scene.start;
  for (std::size_t v = 0; v < points.size(); ++v)
    for (std::size_t k = 0; k < 3; ++k) points[v][k] += t * (scene.end[v][k] - scene.start[v][k]);
  return points;
}

class KeepDistance : public testing::TestWithParam<Recipe> {};

// Bugs: a reach too short for the boxes, for the axes, or for displacements of different sign.
TEST_P(KeepDistance, MethodsGiveTheSameBits) {
  for (std::uint64_t seed = 0; seed < 4; ++seed)
    for (const double part : {1.0, 0x1p-6}) {
      Scene scene = GetParam().make(40 + 60 * static_cast<Index>(seed), 71 + seed);
      scene.end = between(scene, part);
      for (const double fraction : {0x1p-30, 0.1, 0.5, 0.9, 1 - 0x1p-40})
        for (const double separation : {0.0, 0x1p-12}) {
          const SafeStep truth = keep(scene, fraction, with(Method::brute, separation));
          for (const Method method : {Method::tamis, Method::paper})
            expect_same(keep(scene, fraction, with(method, separation)), truth,
                        scene.name + " by " + std::string(name_of(method)) + ", seed " + std::to_string(71 + seed) +
                            ", part " + std::to_string(part) + ", fraction " + std::to_string(fraction));
        }
    }
}

/// All turned by so much about an axis through no symmetry of anything, and moved: nothing changes its shape at t=1.
Scene turned(const Scene& scene, double angle, double far) {
  Scene result = scene;
  const double c = std::cos(angle), s = std::sin(angle);
  for (std::size_t v = 0; v < scene.start.size(); ++v) {
    const Point& p = scene.start[v];
    const double y = 0.6 * p[1] + 0.8 * p[2], z = 0.6 * p[2] - 0.8 * p[1];
    const double x = c * p[0] - s * y + far, w = s * p[0] + c * y - 2 * far;
    result.end[v] = {x, 0.6 * w - 0.8 * z, 0.8 * w + 0.6 * z};
  }
  return result;
}

// Bug: a pair that is left out because it moves or turns as a whole, but comes too near on its way; by a half turn all
// pass through one line.
TEST_P(KeepDistance, MethodsGiveTheSameBitsOnFastMotion) {
  for (std::uint64_t seed = 0; seed < 2; ++seed) {
    const Scene scene = GetParam().make(60, 91 + seed);
    const double separation = seed == 0 ? 0 : 0x1p-7;
    for (const double angle : {0.3, 1.05, 3.1})
      for (const double far : {0.0, 1000.0}) {
        const Scene moved = turned(scene, angle, far);
        for (const double fraction : {0.05, 0.2, 0.8}) {
          const SafeStep truth = keep(moved, fraction, with(Method::brute, separation));
          expect_same(keep(moved, fraction, with(Method::tamis, separation)), truth,
                      scene.name + ", angle " + std::to_string(angle) + ", far " + std::to_string(far) + ", fraction " +
                          std::to_string(fraction));
        }
      }
  }
}

/// Every object turned by its own angle and stretched, and besides moved by a part of its own motion.
Scene turned_each(const Scene& scene, double angle, double stretch, double part) {
  Scene result = scene;
  const Components objects = components_of(scene.mesh());
  for (std::size_t v = 0; v < scene.start.size(); ++v) {
    const double own = angle * (1 + 0.5 * objects.of_vertex[v]), c = std::cos(own), s = std::sin(own);
    const auto& [x, y, z] = scene.start[v];
    const Point whole{c * x - s * y, stretch * (s * x + c * y), z + 0.3 * own};
    for (std::size_t k = 0; k < 3; ++k) result.end[v][k] = whole[k] + part * (scene.end[v][k] - scene.start[v][k]);
  }
  return result;
}

// Bugs: what pairs lose besides the motion they share is taken for less than it is, is not paid for in full where they
// shrink together or have a separation, or is compared between objects that share none.
TEST_P(KeepDistance, MethodsGiveTheSameBitsBesideASharedMotion) {
  for (const double angle : {0.0, 0.6, -1.4})
    for (const double stretch : {1.0, 0.5})
      for (const double part : {1e-3, 0.1}) {
        const Scene moved = turned_each(GetParam().make(60, 95), angle, stretch, part);
        for (const double fraction : {0.05, 0.4})
          for (const double separation : {0.0, 0x1p-6})
            expect_same(keep(moved, fraction, with(Method::tamis, separation)),
                        keep(moved, fraction, with(Method::brute, separation)),
                        moved.name + ", angle " + std::to_string(angle) + ", stretch " + std::to_string(stretch) +
                            ", part " + std::to_string(part) + ", fraction " + std::to_string(fraction) +
                            ", separation " + std::to_string(separation));
      }
}

// Bug: whatever makes a pair come nearer than promised; distances are rounded here, so by more than that only.
TEST_P(KeepDistance, SampledDistancesStayAboveTheFraction) {
  const Scene scene = GetParam().make(60, 5);
  const Mesh mesh = scene.mesh();
  for (const double fraction : {0.1, 0.7}) {
    const SafeStep safe = keep(scene, fraction);
    for (const double part : {0.25, 0.5, 0.875, 1.0}) {
      const std::vector<Point> now = between(scene, part * safe.lower);
      const Step step{scene.start, now};
      for_each_pair(mesh, {}, [&](PairKind kind, const PairVertices& v) {
        const PairPoints points = points_of(step, v);
        const double before = start_distance(kind, points), after = start_distance(kind, {points.end, points.end});
        EXPECT_GE(after, fraction * before * (1 - 1e-9) - 1e-14) << v[0] << " " << v[1] << " " << v[2] << " " << v[3];
      });
    }
  }
}

TEST_P(KeepDistance, ThreadsAndInstructionSetsChangeNoBit) {
  const Scene scene = GetParam().make(GetParam().scales ? 4000 : 300, 77);
  Options options;
  options.threads = 1;
  const SafeStep one = keep(scene, 0.3, options);
  for (const Isa isa : {Isa::baseline, Isa::avx2, Isa::avx512}) {
    options.isa = isa;
    try {
      for (options.threads = 1; options.threads <= 2; ++options.threads)
        for (int repetition = 0; repetition < 2; ++repetition)
          expect_same(keep(scene, 0.3, options), one, std::string(name_of(isa)));
    } catch (const InvalidOptions&) {  // this machine has no such instructions
    }
  }
}

/// All of it in a corner of a frame that is larger by 2^exponent, where a triangle stays.
Scene in_a_corner(Scene scene, int exponent) {
  for (auto* points : {&scene.start, &scene.end})
    for (Point& p : *points)
      for (std::size_t axis = 0; axis < 3; ++axis) p[axis] = 0.7 + std::ldexp(p[axis], -exponent);
  const Index first = scene.vertex_count();
  for (const Point& p : {Point{-1, -1, -1}, {-1, -1, -0.9}, {-1, -0.9, -1}}) scene.add_vertex(p, p, 0);
  scene.faces.push_back({first, first + 1, first + 2});
  return scene;
}

// Bug: floats in a common frame, in which distances are as small as what rounding hides, prove what is not so.
TEST_P(KeepDistance, RoundingInALargeFrameChangesNoBit) {
  for (const int exponent : {8, 14, 18, 20, 22, 24, 28}) {
    const Scene scene = in_a_corner(GetParam().make(40, 83), exponent);
    for (const double fraction : {0.05, 0.5, 0.97})
      for (const double separation : {0.0, std::ldexp(0.01, -exponent)})
        expect_same(keep(scene, fraction, with(Method::tamis, separation)),
                    keep(scene, fraction, with(Method::brute, separation)),
                    scene.name + ", 2^" + std::to_string(exponent) + ", fraction " + std::to_string(fraction));
  }
}

TEST_P(KeepDistance, UnitOfLengthChangesNoBit) {
  const Scene scene = GetParam().make(80, 78);
  const SafeStep reference = keep(scene, 0.2);
  for (const int exponent : {-200, -30, 30, 200}) {
    Scene scaled = scene;
    for (auto* points : {&scaled.start, &scaled.end})
      for (Point& p : *points)
        for (double& x : p) x = std::ldexp(x, exponent);
    const SafeStep safe = keep(scaled, 0.2);
    EXPECT_EQ(safe.lower, reference.lower) << exponent;
    EXPECT_EQ(safe.upper, reference.upper) << exponent;
  }
}

/// Coordinates times a power of two such that the largest is at the end of the range of doubles.
Scene at_the_end_of_the_range(Scene scene) {
  double largest = 0;
  for (const auto* points : {&scene.start, &scene.end})
    for (const Point& p : *points)
      for (const double x : p) largest = std::max(largest, std::abs(x));
  for (auto* points : {&scene.start, &scene.end})
    for (Point& p : *points)
      for (double& x : p) x = std::ldexp(x, 1023 - std::ilogb(largest));
  return scene;
}

// Bug: where differences overflow, nothing is known of a pair, and so the whole step may go.
TEST_P(KeepDistance, DifferencesThatOverflowChangeNoBit) {
  const Scene scene = GetParam().make(80, 79), large = at_the_end_of_the_range(scene);
  for (const double fraction : {0.0, 0.2, 0.8}) {
    const SafeStep reference = keep(scene, fraction);
    for (const Method method : kMethods) {
      const SafeStep safe = keep(large, fraction, with(method));
      EXPECT_EQ(safe.lower, reference.lower) << name_of(method) << " " << fraction;
      EXPECT_EQ(safe.upper, reference.upper) << name_of(method) << " " << fraction;
    }
  }
}

// Bug: what contacts say and what distances say are two stories.
TEST_P(KeepDistance, EndsBeforeTheEarliestContact) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const Scene scene = GetParam().make(100, 80 + seed);
    for (const Method method : kMethods) {
      const EarliestContact first = Detector(scene.mesh(), with(method)).earliest(scene.step());
      const SafeStep none = keep(scene, 0, with(method)), tiny = keep(scene, 1e-6), half = keep(scene, 0.5);
      EXPECT_EQ(none.lower, first.toi_lower);
      EXPECT_EQ(none.upper, none.lower == 0 ? 0 : first.toi_upper);
      EXPECT_EQ(none.pair.has_value(), first.contact.has_value());
      EXPECT_LE(tiny.lower, first.toi_upper);
      EXPECT_LE(half.lower, tiny.lower);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, KeepDistance, testing::ValuesIn(scenes::recipes().begin(), scenes::recipes().end()),
                         scene_test_name);

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
      EXPECT_LE(safe.lower, truth * (1 + 1e-12));
      EXPECT_LE(truth * (1 - 1e-12), safe.upper);
      EXPECT_LE(safe.upper - safe.lower, 1e-9);
      ASSERT_TRUE(safe.pair);
      EXPECT_EQ(safe.pair->vertices, (std::array<Index, 4>{3, 0, 1, 2}));
      EXPECT_EQ(safe.pair->distance, 1);
    }
}

TEST_P(KnownStep, CountsTheDistanceBeyondTheMinimumSeparation) {
  const SafeStep safe = keep(falling_point(1, -1), 0.5, with(GetParam(), 0.5));
  EXPECT_NEAR(safe.lower, 0.125, 1e-9);
  EXPECT_LE(safe.lower, 0.125);
  EXPECT_EQ(keep(falling_point(1, -1), 0.5, with(GetParam(), 1)).lower, 0) << "within it at t=0";
  EXPECT_GT(keep(falling_point(1, -1), 0.5, with(GetParam(), std::nextafter(1.0, 0.0))).lower, 0);
}

/// A triangle that turns about the z axis through its middle, and moves.
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

// Bug: what shrinks as a whole seems to keep its distance, though the separation does not shrink with it.
TEST_P(KnownStep, ShrinksAsAWholeUntilItIsWithinTheSeparation) {
  Scene scene;
  for (const double height : {0.0, 1.0})
    add_turning(scene, {{{0, 0, height}, {0.01, 0, height}, {0, 0.01, height}}}, 0.5, {0, 0, -0.5 * height});
  const SafeStep safe = keep(scene, 0.25, with(GetParam(), 0.8));
  EXPECT_NEAR(safe.lower, (1 - 0.8 - 0.25 * 0.2) / 0.5, 1e-3);
  EXPECT_TRUE(safe.pair);
}

// Bug: both keep their shape, so they seem to keep their distance.
TEST_P(KnownStep, ObjectsThatTurnByThemselvesMeet) {
  Scene scene;
  add_turning(scene, {{{-1, 0, 0}, {1, 0, 0}, {0, 0.01, 0}}}, 1, {0, 0, 0});
  add_turning(scene, {{{0.7, 0.4, 0}, {0.71, 0.4, 0.01}, {0.7, 0.41, 0}}}, -1, {0, 0, 0});
  const SafeStep safe = keep(scene, 0.25, with(GetParam()));
  EXPECT_GT(safe.lower, 0.3);
  EXPECT_LT(safe.lower, 0.6);  // two thirds of the way to tan(angle) = 0.4 / 0.7
}

TEST_P(KnownStep, GoesAllTheWayAtRestAndAway) {
  for (const double end : {0.25, 1.0})
    for (const double fraction : {0.0, 0.5, 0.999}) {
      const SafeStep safe = keep(falling_point(0.25, end), fraction, with(GetParam()));
      EXPECT_EQ(safe.lower, 1);
      EXPECT_EQ(safe.upper, 1);
      EXPECT_FALSE(safe.pair);
    }
}

// Bug: an optimizer is stopped for ever because doubles cannot tell touching from nearly touching.
TEST_P(KnownStep, IsZeroOnlyIfTheyTouchAtTheStart) {
  for (const double fraction : {0.0, 0.5, 1 - 0x1p-53}) {
    const SafeStep touching = keep(falling_point(0, -1), fraction, with(GetParam()));
    EXPECT_EQ(touching.lower, 0);
    EXPECT_EQ(touching.upper, 0);
    EXPECT_TRUE(touching.pair);
    for (const double height : {0x1p-1000, 0x1p-500, 1e-20, 1e-9})
      EXPECT_GT(keep(falling_point(height, -1), fraction, with(GetParam())).lower, 0) << height << " " << fraction;
    for (const double height : {1e-9, 1e-15})
      EXPECT_EQ(keep(falling_point(height, height), fraction, with(GetParam())).lower, 1) << height << " " << fraction;
  }
}

TEST_P(KnownStep, FacesOfNoAreaKeepTheirDistanceToo) {
  Scene scene = falling_point(1, -1);
  scene.start[2] = scene.end[2] = {0.5, 0, 0};  // on the line of the other two
  scene.start[3] = {0.25, 0, 1};
  scene.end[3] = {0.25, 0, -1};
  EXPECT_NEAR(keep(scene, 0.5, with(GetParam())).lower, 0.25, 1e-9);
}

TEST_P(KnownStep, FiltersLeaveOutPairs) {
  const Scene scene = falling_point(1, -1);
  Options options = with(GetParam());
  options.filter.accepts = [](PairKind, const std::array<Index, 4>&) { return false; };
  for (const double fraction : {0.0, 0.5}) EXPECT_EQ(keep(scene, fraction, options).lower, 1);
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
    EXPECT_NEAR(safe.lower, 0.5 * (1 - fraction), 1e-12);
    EXPECT_NEAR(safe.upper, 0.5 * (1 - fraction), 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, KnownStep, testing::ValuesIn(kMethods),
                         [](const testing::TestParamInfo<Method>& method) { return test_name(name_of(method.param)); });

// Bug: boxes, an order, or a time left over from an earlier question.
TEST(KeepDistanceReuse, AnswersAsANewDetectorWould) {
  const Scene scene = scenes::scene_by_name("folded-cloth", 1000, 1);
  Detector kept(scene.mesh());
  for (const double part : {1.0, 0.01, 0.5, 1.0}) {
    const std::vector<Point> end = between(scene, part);
    const Step step{scene.start, end};
    for (const double fraction : {0.5, 0.0, 0.9})
      expect_same(kept.keep_distance(step, fraction), Detector(scene.mesh()).keep_distance(step, fraction), "kept");
    EXPECT_EQ(kept.is_free(step), Detector(scene.mesh()).is_free(step));
  }
}

}  // namespace
}  // namespace tamis::test

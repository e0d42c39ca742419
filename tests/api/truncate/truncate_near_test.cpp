// Truncated steps of scenes with a few features: near pairs move as far as they may.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "api/truncate/truncated.hpp"
#include "support/contact_sets.hpp"
#include "support/yardstick/methods.hpp"
#include "tamis/detector.hpp"

namespace tamis::test {
namespace {

using yardstick::Method;

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

// Bug, once: at the positions returned, 30 of 234 such points touched or were nearer than the separation by 8e-10,
// because there was no slack for the rounding of positions.
TEST(Truncate, LeavesRoomForRoundingHoweverLittleThereIs) {
  int moved = 0;
  for (const double far : {0.0, 1.0, 1000.0, 8e6})
    for (const double separation : {0.0, 0x1p-10})
      for (const double size : {1.0, 0.3, 1e-3})
        for (int ulps = 1; ulps <= 10; ++ulps) {
          const double surface = far / 3;  // no round number
          const double ulp = std::nextafter(surface + separation, HUGE_VAL) - (surface + separation);
          Scene scene = two_falls(separation + ulps * ulp, 0.7, {far, -far, surface}, size);
          Detector detector = yardstick::make_detector(scene.mesh(), with(Method::tamis, separation));
          if (!detector.is_free({scene.start, scene.start})) continue;  // rounding has closed the gap
          const TruncatedStep to = detector.truncate(scene.step());
          SCOPED_TRACE(testing::Message() << ulps << " ulps above, at " << far << ", separation " << separation);
          EXPECT_TRUE(to.is_free);
          EXPECT_TRUE(detector.is_free({scene.start, to.positions}));
          EXPECT_TRUE(detector.is_free({to.positions, to.positions}));
          expect_kept(scene, to.positions, 0.1, separation);
          EXPECT_LT(to.positions[7][2], scene.start[7][2]) << "the other one";
          for (std::size_t v = 0; v < 7; ++v)
            EXPECT_TRUE(v == 3 || to.positions[v] == scene.start[v]) << v << " stands still";
          moved += to.positions[3] != scene.start[3];
        }
  EXPECT_GT(moved, 50);
}

// Bug: no reach if the square of a length is infinite. The face slides within its plane until it meets a point.
TEST(Truncate, AVertexDoesNotPassAFaceThatIsFast) {
  for (const double away : {1e3, 1e150, 4e159, 1e300}) {
    const Mesh mesh(5, {{0, 1, 2}}, {}, {3, 4});
    const std::vector<Point> start{{-1, -1, 0}, {2, -1, 0}, {-1, 2, 0}, {0.7, 0, 0.5}, {2.5, 0, 0}};
    std::vector<Point> end = start;
    for (std::size_t v = 0; v < 3; ++v) end[v][0] += away;
    end[3][2] = -0.5;
    Detector detector(mesh);
    const TruncatedStep to = detector.truncate({start, end}, 0.1);
    EXPECT_LT(to.fractions[3], 0.5) << away;
    EXPECT_TRUE(detector.is_free({start, to.positions})) << away;
  }
}

// Bug: a question that keeps nearly all of each distance never ended. Even features at rest were not proven to keep so
// much, because rounding alone takes more.
TEST(Truncate, EndsHoweverMuchIsKept) {
  for (const double above : {0.5, 1e-3, 1e-7})
    for (const double lost : {0x1p-25, 0x1p-40, 0x1p-53}) {
      const Scene scene = two_falls(above, 1);
      long asked = 0;
      yardstick::Options options;
      options.is_cancelled = [&] { return ++asked > 20000; };
      Detector detector = yardstick::make_detector(scene.mesh(), options);
      const TruncatedStep to = detector.truncate(scene.step(), 1 - lost);
      EXPECT_TRUE(to.is_free) << above << ", " << lost;
      EXPECT_TRUE(detector.is_free({scene.start, to.positions})) << above << ", " << lost;
    }
}

// Bug, once: nothing moved at all, and nine searches found the same contact.
TEST(Truncate, WhatTouchesAtTheStartStaysAndIsAskedAboutOnce) {
  const Scene scene = two_falls(0, 1);
  yardstick::Options options;
  std::atomic<int> asked = 0;
  options.filter.accepts = [&](PairKind kind, const std::array<Index, 4>& v) {
    asked += kind == PairKind::vertex_face && v[0] == 3 && v[1] == 0;
    return true;
  };
  Detector detector = yardstick::make_detector(scene.mesh(), options);
  const TruncatedStep to = detector.truncate(scene.step());
  EXPECT_FALSE(to.is_free);
  EXPECT_EQ(to.positions[3], scene.start[3]);
  EXPECT_EQ(to.fractions[3], 0);
  EXPECT_EQ(to.positions[7], scene.end[7]);
  EXPECT_LE(asked, 4) << "how far together, what is within reach, and whether it holds; once more where it does not";
}

// Bug, once: a pair within the separation froze every vertex, also one that leaves.
TEST(Truncate, WhatStartsWithinTheSeparationMayLeaveButNotComeNearer) {
  constexpr double kSeparation = 0x1p-4;
  for (const double fall : {-0.05, 1.0}) {
    const Scene scene = two_falls(0.5 * kSeparation, fall);
    const TruncatedStep to =
        yardstick::make_detector(scene.mesh(), with(Method::tamis, kSeparation)).truncate(scene.step());
    EXPECT_FALSE(to.is_free);
    expect_kept(scene, to.positions, 0.1, kSeparation);
    EXPECT_EQ(to.positions[7], scene.end[7]);
    EXPECT_EQ(to.positions[3], fall < 0 ? scene.end[3] : scene.start[3]);
  }
}

/// Triangles above each other, a hundredth apart. All but the lowest fall by one half; a point touches the lowest at
/// the start if `touches`.
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

// Bug: each layer stops one round after the layer below it. When the rounds are used up, all vertices go back to the
// end of the common step, which is the start if any pair touches there.
TEST(Truncate, AStackSettlesHoweverHighItIs) {
  for (const int layers : {10, 80})
    for (const bool touches : {false, true}) {
      const Scene scene = stack(layers, touches);
      const TruncatedStep to = Detector(scene.mesh()).truncate(scene.step(), 0.1);
      EXPECT_EQ(to.is_free, !touches);
      expect_kept(scene, to.positions, 0.1, 0);
      for (std::size_t v = 3; v < 3 * static_cast<std::size_t>(layers); ++v)
        EXPECT_GT(to.fractions[v], 0) << "layer " << v / 3 << " of " << layers;
    }
}

// Bug, once: pairs were listed by each vertex' reach and own radius, though an edge has the radius of its thick end at
// its thin end, too.
TEST(Truncate, TheThinEndOfAThickEdgeGoesNoNearerThanTheEdgeMay) {
  Scene scene;
  const auto add = [&](const Point& start, const Point& end, Index group) {
    return scene.add_vertex(start, end, group);
  };
  const Index thin = add({0, 0, 12}, {0, 0, 9}, 0), thick = add({100, 0, 12}, {100, 0, 12}, 1);
  scene.loose_edges.push_back({thin, thick});
  const Index below = add({0, -1, 0}, {0, -1, 0}, 0);
  scene.loose_edges.push_back({below, add({0, 1, 0}, {0, 1, 0}, 0)});
  for (int i = 0; i < 200; ++i) {  // these stay, so that the mean displacement is short
    const Point at{-100.0 - i, 0, 0};
    scene.loose_points.push_back(add(at, at, 0));
  }
  Options options;
  options.filter = {scene.group_of_vertex, 2};
  options.radii = {0, 10};
  const TruncatedStep to = Detector(scene.mesh(), options).truncate(scene.step(), 0.1);
  EXPECT_GE(to.positions[0][2], 10.2);
  EXPECT_LT(to.positions[0][2], 10.3);
  EXPECT_TRUE(Detector(scene.mesh(), options).is_free({scene.start, to.positions}));
}

// Bug: a mesh without edges has no length by which to measure reach, and does not move.
TEST(Truncate, PointsAloneGoTheirWay) {
  const std::vector<Point> start{{0, 0, 0}, {1, 0, 0}, {0, 5, 0}}, end{{2, 0, 0}, {-1, 0, 0}, {0, 9, 0}};
  const TruncatedStep to = Detector(Mesh(3, {}, {}, {0, 1, 2})).truncate({start, end}, 0.1);
  EXPECT_TRUE(to.is_free);
  EXPECT_EQ(to.positions[2], end[2]);
  EXPECT_GE(to.positions[1][0] - to.positions[0][0], 0.1);
  EXPECT_LT(to.positions[1][0] - to.positions[0][0], 0.2);
}

// Bug: a pair that touched at the start, and was ignored, came back and touched at the very end.
TEST(Truncate, WhatIsIgnoredAtTheStartDoesNotTouchAtTheEnd) {
  const std::vector<Point> start{{0, 0, 0}, {1, 0, 2}, {0, 1, 2}, {0, 0, 0}};
  const std::vector<Point> end{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, 0}};
  Detector detector(Mesh(4, {{0, 1, 2}}, {}, {3}));
  const QueryOptions ignore{.at_start = AtStart::ignore};
  const TruncatedStep to = detector.truncate({start, end}, 0.1, ignore);
  EXPECT_TRUE(to.is_free);
  EXPECT_TRUE(detector.is_free({start, to.positions}, ignore));
  EXPECT_TRUE(detector.safe_step({start, end}, 0.1, ignore).pair.has_value());
}

/// Adds a point that touches a triangle, far from the others, so that there is no common step.
void add_touching(std::vector<Point>& points) {
  for (const Point& p : {Point{10, 0, 0}, Point{11, 0, 0}, Point{10, 1, 0}, Point{10.25, 0.25, 0}}) points.push_back(p);
}

// Bug: a point, which has no edges, went no farther than a part of the finest body's edges, wherever that body was.
TEST(Truncate, APointGoesOnHoweverFineABodyIsElsewhere) {
  for (const double size : {1.0, 1e-3, 1e-6}) {
    std::vector<Point> start{{100, 0, 0}, {100 + size, 0, 0}, {100, size, 0}, {0, 0, 100}};
    add_touching(start);
    std::vector<Point> end = start;
    end[3][0] += 1;
    const TruncatedStep to = Detector(Mesh(8, {{0, 1, 2}, {4, 5, 6}}, {}, {3, 7})).truncate({start, end}, 0.1);
    EXPECT_GT(to.fractions[3], 0.1) << size;
  }
}

// Bug: a face that slides within its plane, or leaves it by rounding only, was held by a point that falls on it: its
// side of the planes had no slack at all.
TEST(Truncate, AFaceSlidesBelowWhatFallsOnIt) {
  for (const StoredType stored : {StoredType::float64, StoredType::float32})
    for (int turn = 0; turn < 24; ++turn) {
      const double c = std::cos(0.1 * turn), s = std::sin(0.1 * turn);
      const auto turned = [&](const Point& p) { return Point{p[0], c * p[1] - s * p[2], s * p[1] + c * p[2]}; };
      std::vector<Point> start, end;
      for (const Point& p : {Point{0, 0, 0.5}, Point{1, 0, 0.5}, Point{0, 1, 0.5}}) {
        start.push_back(turned(p));
        end.push_back(turned({p[0] + 0.1, p[1] + 0.05, p[2]}));
      }
      start.push_back(turned({0.25, 0.25, 0.7}));
      end.push_back(turned({0.25, 0.25, -0.3}));
      add_touching(start);
      if (stored == StoredType::float32) start = as_floats(start);
      end.insert(end.end(), start.begin() + 4, start.end());
      const auto to = Detector(Mesh(8, {{0, 1, 2}, {4, 5, 6}}, {}, {3, 7})).truncate({start, end}, 0.1, {}, stored);
      for (std::size_t v = 0; v < 3; ++v) EXPECT_GT(to.fractions[v], 0.5) << turn << ", vertex " << v;
      EXPECT_GT(to.fractions[3], 0.1) << turn;
    }
}

// Bug: the search for planes overwrites the pairs that `pairs_within` has returned.
TEST(Truncate, LeavesOtherAnswersAlone) {
  const Scene scene = two_falls(0.5, 1);
  Detector detector(scene.mesh());
  const auto& near = detector.pairs_within(scene.start, 0.6);
  const auto before = near;
  ASSERT_EQ(before.size(), 1u);
  (void)detector.truncate(scene.step());
  ASSERT_EQ(near.size(), 1u);
  EXPECT_EQ(near[0].vertices, before[0].vertices);
}

}  // namespace
}  // namespace tamis::test

// Compares intersections in one pose with exact decisions of every edge with every face, and with the oracle.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "pair/exact/exact.hpp"
#include "support/contact_sets.hpp"
#include "support/copied.hpp"
#include "support/kernels_here.hpp"
#include "support/test_names.hpp"
#include "support/yardstick/methods.hpp"
#include "tamis/detector.hpp"
#include "tamis/error.hpp"

namespace tamis::test {
namespace {

using scenes::Recipe, scenes::Scene;

using Found = std::multiset<std::pair<Edge, Face>>;

Found found_by(Detector& detector, const std::vector<Point>& positions) {
  Found found;
  for (const Intersection& i : detector.intersections(positions)) found.insert({i.edge, i.face});
  return found;
}

/// Decides every edge with every face: as a point that moves along the edge, against the face at rest.
template <class Touches>
Found truth_by(const Mesh& mesh, const std::vector<Point>& at, const Touches& touches) {
  const auto point = [&](Index v) { return at[static_cast<std::size_t>(v)]; };
  Found truth;
  for (const Edge& edge : mesh.edges())
    for (const Face& face : mesh.faces()) {
      if (std::any_of(face.begin(), face.end(), [&](Index v) { return v == edge[0] || v == edge[1]; })) continue;
      const std::array start{point(edge[0]), point(face[0]), point(face[1]), point(face[2])};
      auto end = start;
      end[0] = point(edge[1]);
      if (touches(start, end)) truth.insert({edge, face});
    }
  return truth;
}

class IntersectionsOf : public testing::TestWithParam<Recipe> {};

// Bugs: a pair lost in the search or the filters, or an adjacent one reported; another answer by another method.
TEST_P(IntersectionsOf, AreThoseOfEveryEdgeWithEveryFace) {
  for (std::uint64_t seed = 0; seed < 2; ++seed) {
    const Scene scene = GetParam().make(60, 5 + seed);
    const Mesh mesh = scene.mesh();
    const Found truth = truth_by(mesh, scene.end, [](const auto& start, const auto& end) {
      return decide_exactly(PairKind::vertex_face, {start, end}).touches();
    });
    for (const Method method : kMethods) {
      yardstick::Options options;
      options.method = method;
      Detector detector = yardstick::make_detector(scene.mesh(), options);
      EXPECT_EQ(found_by(detector, scene.end), truth) << scene.name << " by " << name_of(method);
      EXPECT_EQ(detector.has_intersection(scene.end), !truth.empty());
      EXPECT_EQ(found_by(detector, scene.end), truth) << "asked again";
    }
  }
}

// Bug: the library's own exact decision is wrong in the same way as its search.
TEST_P(IntersectionsOf, AreThoseOfTheOracle) {
  const Scene scene = GetParam().make(12, 3);
  Detector detector(scene.mesh());
  EXPECT_EQ(found_by(detector, scene.start),
            truth_by(scene.mesh(), scene.start, [](const auto& start, const auto& end) {
              return oracle::touches(PairKind::vertex_face, {start, end});
            }));
}

bool are_same(const Intersection& a, const Intersection& b) {
  return a.edge == b.edge && a.face == b.face && a.s_lower == b.s_lower && a.s_upper == b.s_upper && a.u == b.u &&
         a.v == b.v;
}

// Bugs: a lane that reads another pair's end of an edge; an answer that depends on which thread found it.
TEST_P(IntersectionsOf, HaveTheSameBitsWithAnyThreadsAndInstructionSet) {
  const Scene scene = GetParam().make(2000, 7);
  const auto reference = intersections_of(Detector(scene.mesh()), scene.end);
  for (const Isa isa : every_isa())
    for (const int threads : {1, 3}) {
      yardstick::Options options;
      options.isa = isa;
      options.threads = threads;
      try {
        const auto found = intersections_of(yardstick::make_detector(scene.mesh(), options), scene.end);
        EXPECT_TRUE(std::equal(found.begin(), found.end(), reference.begin(), reference.end(), are_same))
            << name_of(isa) << ", " << threads << " threads";
      } catch (const InvalidOptions&) {  // this machine lacks the instruction set
      }
    }
}

// Bug: boxes at rest, or the pose for which they were made, are left over in the trees that all questions share.
TEST_P(IntersectionsOf, ChangeNoAnswerAboutSteps) {
  const Scene scene = GetParam().make(500, 8);
  Detector fresh(scene.mesh()), kept(scene.mesh());
  const EarliestContact first = fresh.earliest(scene.step());
  for (const auto* pose : {&scene.start, &scene.end, &scene.start}) {
    const bool meets = kept.has_intersection(*pose);
    const EarliestContact again = kept.earliest(scene.step());
    EXPECT_EQ(again.toi_lower, first.toi_lower);
    EXPECT_EQ(again.toi_upper, first.toi_upper);
    EXPECT_EQ(kept.has_intersection(*pose), meets);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, IntersectionsOf, testing::ValuesIn(scenes::recipes().begin(), scenes::recipes().end()),
                         scene_test_name);

/// A face in the plane z = 0, and a rod from `a` to `b`.
bool meets_face(const Point& a, const Point& b) {
  Detector detector(Mesh(5, {{0, 1, 2}}, {{3, 4}}));
  const std::vector<Point> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, a, b};
  return detector.has_intersection(positions);
}

// Bugs: touching does not count as an intersection, or every edge in the face's plane does.
TEST(IntersectionsThatOnlyTouch, Count) {
  EXPECT_TRUE(meets_face({0.25, 0.25, 0}, {0.25, 0.25, 1})) << "an end on the inside";
  EXPECT_TRUE(meets_face({0.5, 0, -1}, {0.5, 0, 1})) << "through a border";
  EXPECT_TRUE(meets_face({0, 0, -1}, {0, 0, 1})) << "through a corner";
  EXPECT_TRUE(meets_face({-1, 0.5, 0}, {1, 0.25, 0})) << "within the plane, across";
  EXPECT_TRUE(meets_face({0.25, 0.25, 0}, {0.3, 0.3, 0})) << "within the face";
  EXPECT_FALSE(meets_face({-1, -1, 0}, {1, -1, 0})) << "within the plane, beside it";
  EXPECT_FALSE(meets_face({0.25, 0.25, 0x1p-1074}, {0.25, 0.25, 1})) << "the smallest double above it";
  EXPECT_FALSE(meets_face({2, 2, -1}, {2, 2, 1})) << "past it";
}

// Bug: intersections of groups that may pass through each other are reported.
TEST(IntersectionsOfGroups, FollowTheFilter) {
  yardstick::Options options;
  const std::vector<Point> pierced{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, -1}, {0.2, 0.2, 1}};
  for (const Method method : kMethods) {
    options.method = method;
    options.filter = PairFilter::no_self_contact({0, 0, 0, 0, 0});
    EXPECT_FALSE(yardstick::make_detector(Mesh(5, {{0, 1, 2}}, {{3, 4}}), options).has_intersection(pierced))
        << name_of(method);
    options.filter = PairFilter::no_self_contact({0, 0, 0, 1, 1});
    EXPECT_TRUE(yardstick::make_detector(Mesh(5, {{0, 1, 2}}, {{3, 4}}), options).has_intersection(pierced))
        << name_of(method);
  }
}

TEST(IntersectionsBadInput, IsRefused) {
  Detector detector(Mesh(5, {{0, 1, 2}}, {{3, 4}}));
  const std::vector<Point> few(4), not_finite(5, Point{NAN, 0, 0});
  EXPECT_THROW((void)detector.intersections(few), InvalidStep);
  EXPECT_THROW((void)detector.has_intersection(not_finite), InvalidStep);
}

}  // namespace
}  // namespace tamis::test

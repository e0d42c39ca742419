// A few pairs that touch at the start: the message that refuses them, radii, curves, and how often they are counted.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "api/at_start/at_start_options.hpp"
#include "tamis/detector.hpp"
#include "tamis/error.hpp"
#include "tamis/rigid_path.hpp"

namespace tamis::test {
namespace {

/// A point that moves against a triangle, and another triangle beside it.
struct OnAFace : testing::Test {
  Mesh mesh{7, {{0, 1, 2}, {4, 5, 6}}, {}, {3}};
  std::vector<Point> start{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, 0}, {3, 0, 0}, {4, 0, 0}, {3, 1, 0}},
      end = start;
};

// Bugs: a message without the pair, the separation or advice; a question that is refused though nothing touches.
TEST_F(OnAFace, FailureNamesThePair) {
  const auto sentence_of = [&](double separation) -> std::string {
    Detector detector(mesh);
    try {
      (void)detector.contacts({start, end}, {.min_separation = separation, .at_start = AtStart::fail});
    } catch (const InvalidStep& refusal) {
      return refusal.what();
    }
    return "";
  };
  EXPECT_EQ(sentence_of(0),
            "vertex 3 and face 0 1 2 touch at the start of the step: move them apart, leave the pair out, or pass "
            "at_start ignore");
  EXPECT_NE(sentence_of(0.125).find("within 0.125 of each other"), std::string::npos);
  start[3][2] = end[3][2] = 0.5;
  EXPECT_EQ(sentence_of(0.125), "");
  EXPECT_NE(sentence_of(0.5).find("vertex 3 and face 0 1 2"), std::string::npos);
  end[3][2] = -0.5;
  EXPECT_EQ(sentence_of(0), "") << "what only comes to touch";
}

// Bug: radii do not count when a pair is tested for touching at the start.
TEST_F(OnAFace, RadiiCountAtTheStart) {
  start[3][2] = 0.25;
  end[3][2] = 1;
  Options options;
  options.radii = {0.125};
  Detector detector(mesh, options);
  EXPECT_FALSE(detector.is_free({start, end}));
  EXPECT_TRUE(detector.is_free({start, end}, kIgnore));
  EXPECT_EQ(detector.statistics().ignored, 1u);
  EXPECT_THROW((void)detector.is_free({start, end}, kFail), InvalidStep);
}

// Bug: on a curve, pairs that touch at the start are reported whatever the question asks for.
TEST_F(OnAFace, CurvesIgnoreAndFailToo) {
  class Still : public Path {
   public:
    explicit Still(const std::vector<Point>& points) : points_(points) {}
    Index vertex_count() const override { return static_cast<Index>(points_.size()); }
    void points_at(double, std::span<const Index> vertices, std::span<Point> points,
                   std::span<double> errors) const override {
      for (std::size_t i = 0; i < vertices.size(); ++i) points[i] = points_[static_cast<std::size_t>(vertices[i])];
      std::ranges::fill(errors, 0);
    }
    void deviations(double, double, std::span<const Index>, std::span<double> deviations) const override {
      std::ranges::fill(deviations, 0);
    }

   private:
    const std::vector<Point>& points_;
  };
  Detector detector(mesh);
  const Still path(start);
  EXPECT_FALSE(detector.is_free(path));
  EXPECT_EQ(detector.statistics().ignored, 0u);
  EXPECT_TRUE(detector.contacts(path, kIgnoreOnPath).empty());
  EXPECT_EQ(detector.statistics().ignored, 1u);
  EXPECT_FALSE(detector.earliest(path, kIgnoreOnPath).contact);
  EXPECT_EQ(detector.statistics().ignored, 1u);
  EXPECT_TRUE(detector.is_free(path, kIgnoreOnPath));
  EXPECT_EQ(detector.statistics().ignored, 1u);
  EXPECT_THROW((void)detector.contacts(path, kFailOnPath), InvalidStep);
  EXPECT_THROW((void)detector.earliest(path, kFailOnPath), InvalidStep);
  EXPECT_THROW((void)detector.is_free(path, kFailOnPath), InvalidStep);
}

// Bugs: an ignored pair that is not counted, or counted once in each piece of the path; one that is counted though it
// comes back in a later piece.
TEST(AtStart, OnACurveWhatDoesNotComeBackIsIgnoredAndCountedOnce) {
  // A face, and points: one stays on it, one leaves it, one goes round and comes back, one comes from above.
  const std::vector<Point> rest{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {1, 1, 0}, {3, 1, 0}, {2, 0, -1}, {1, 3, 1}};
  const Pose still{{0, 0, 0}, {0, 0, 0}};
  const double whole_turn = 2 * std::acos(-1.0);
  const RigidPath path(rest, {0, 0, 0, 0, 1, 2, 3},
                       {{},
                        interpolated_chain(still, {{0, 0, 1}, {0, 0, 0}}),
                        interpolated_chain({{0, 2, 1}, {0, 0, 0}}, {{0, 2, 1}, {whole_turn, 0, 0}}),
                        interpolated_chain(still, {{0, 0, -1}, {0, 0, 0}})});
  Detector detector(Mesh(7, {{0, 1, 2}}, {}, {3, 4, 5, 6}));
  PathOptions ignore = kIgnoreOnPath;
  ignore.min_separation = 0.01;
  std::span<const Contact> contacts = detector.contacts(path, ignore);
  ASSERT_EQ(contacts.size(), 2u);
  EXPECT_EQ(contacts[0].vertices[0], 5);
  EXPECT_EQ(contacts[1].vertices[0], 6);
  EXPECT_EQ(detector.statistics().ignored, 2u);
}

// Bug: ignored pairs were counted again for each beginning of the step that was searched.
TEST(AtStart, IsCountedOnceWhereAStepGoesVeryFar) {
  const std::vector<Point> start{{-4, -4, 0}, {4, -4, 0}, {0, 4, 0}, {0, 0, 0}, {0.5, 0, 0}, {-0.5, 0, 0}};
  for (const double far : {1.0, 1e5, 1e9}) {
    std::vector<Point> end = start;
    for (const std::size_t v : {3u, 4u, 5u}) end[v][2] += far;
    Detector detector(Mesh(6, {{0, 1, 2}}, {}, {3, 4, 5}));
    for (int time = 0; time < 3; ++time) {
      EXPECT_FALSE(detector.earliest({start, end}, kIgnore).contact);
      EXPECT_EQ(detector.statistics().ignored, 3u) << far << ' ' << time;
    }
  }
}

// Bug: is_free ends at the first contact that it finds, before it decides the pair that touches at the start.
TEST(AtStart, FailsOnACurveThoughOthersTouchLater) {
  for (const Index later : {7, 8, 9, 40}) {
    std::vector<Point> rest{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}};
    for (Index i = 0; i < later; ++i) rest.push_back({0.1 + 0.1 * i, 0.1, 0.01});
    rest.push_back({1, 1, 0});
    std::vector<Index> points(rest.size() - 3), body_of_vertex(rest.size(), 1);
    std::iota(points.begin(), points.end(), 3);
    std::fill_n(body_of_vertex.begin(), 3, 0);
    Detector detector(Mesh(static_cast<Index>(rest.size()), {{0, 1, 2}}, {}, points));
    const RigidPath path(rest, body_of_vertex, {{}, interpolated_chain({}, {{0, 0, -1}, {0, 0, 0.1}})});
    EXPECT_THROW((void)detector.is_free(path, kFailOnPath), InvalidStep) << later;
    EXPECT_FALSE(detector.is_free(path)) << later;
  }
}

}  // namespace
}  // namespace tamis::test

// Paths that break their promises, and questions that make no sense.
#include <gtest/gtest.h>

#include <limits>

#include "curves/paths/turning_pairs.hpp"
#include "tamis/detector.hpp"
#include "tamis/error.hpp"
#include "tamis/spline_path.hpp"

namespace tamis::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A point that falls through a triangle, with whatever bounds and positions it is told to give.
struct ToldPath final : Path {
  Index vertex_count() const override { return 4; }
  void points_at(double time, std::span<const Index> vertices, std::span<Point> points,
                 std::span<double> errors) const override {
    const std::array<Point, 4> all{Point{0.2, 0.2, height - time}, Point{0, 0, 0}, Point{1, 0, 0}, Point{0, 1, 0}};
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      points[i] = all[static_cast<std::size_t>(vertices[i])];
      errors[i] = error;
    }
  }
  void deviations(double, double, std::span<const Index> vertices, std::span<double> deviations) const override {
    for (std::size_t i = 0; i < vertices.size(); ++i) deviations[i] = deviation;
  }
  void straight_directions(std::span<const Index>, std::span<Point> directions) const override {
    for (Point& d : directions) d = {0, 0, direction};
  }
  double height = 0.5, error = 0, deviation = 0, direction = 0;
};

template <class Error, class F>
void expect_message(const F& question, const char* part) {
  try {
    question();
    FAIL() << "no exception that says " << part;
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
  }
}

constexpr std::array<Index, 4> kAll{0, 1, 2, 3};

// Bug: a bound that is not a number compares false and proves everything free.
TEST(BadPath, IsNamed) {
  ToldPath path;
  const auto ask = [&] { (void)vertex_face(path, kAll); };
  EXPECT_TRUE(vertex_face(path, kAll).touches);
  path.deviation = -1e-3;
  expect_message<InvalidPath>(ask, "deviates by -0.001");
  path.deviation = kNan;
  expect_message<InvalidPath>(ask, "deviates by");
  path.deviation = 0;
  path.error = -1;
  expect_message<InvalidPath>(ask, "has the error -1");
  path.error = kNan;
  expect_message<InvalidPath>(ask, "has the error");
  path.error = 0;
  path.direction = kInfinity;
  expect_message<InvalidPath>(ask, "along a direction that is not finite");
  path.direction = 0;
  path.height = kNan;
  expect_message<InvalidPath>(ask, "vertex 0 of the path at t = 0 is not finite");
  path.height = kInfinity;
  expect_message<InvalidPath>(ask, "is not finite");
}

// Bug: bounds that never shrink loop for ever, or end as free.
TEST(BadPath, BoundsThatNeverShrinkAreUnresolved) {
  ToldPath path;
  path.height = 10;
  EXPECT_FALSE(vertex_face(path, kAll).touches);
  for (const double bound : {20.0, kInfinity}) {
    path.deviation = bound;
    EXPECT_EQ(vertex_face(path, kAll).certainty, Certainty::unresolved);
    EXPECT_TRUE(vertex_face(path, kAll).touches);
    path.deviation = 0;
    path.error = bound;
    EXPECT_TRUE(vertex_face(path, kAll).touches);
    EXPECT_EQ(vertex_face(path, kAll).certainty, Certainty::unresolved);
    path.error = 0;
  }
}

// Bug: radii that are not finite make boxes that meet nothing.
TEST(BadPath, OfAMeshIsRefusedWhereItDeviatesWithoutBound) {
  ToldPath path;
  path.deviation = kInfinity;
  Detector detector(Mesh(4, {{1, 2, 3}}, {}, {0}));
  expect_message<InvalidPath>([&] { (void)detector.contacts(path); }, "vertex 0 of the path deviates without bound");
  // Bug: the same was said of positions that may be off by any distance.
  path.deviation = 0;
  path.error = kInfinity;
  expect_message<InvalidPath>([&] { (void)detector.contacts(path); }, "of the path is off without bound after t = 0");
}

// Bug: one that was moved from has no frames, and looked for its vertices in the first one.
TEST(BadPath, ThatHasBeenMovedFromHasNoVertices) {
  BezierPath path({{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 0}, {1, 0, 0}}});
  const BezierPath other(std::move(path));
  EXPECT_EQ(other.vertex_count(), 2);
  expect_message<InvalidPath>([&] { (void)vertex_vertex(path, {0, 1}); }, "the path has no vertex 0");
}

TEST(BadPath, OptionsAndNumbersAreChecked) {
  const ToldPath path;
  expect_message<InvalidPath>([&] { (void)vertex_face(path, {0, 1, 2, 4}); }, "no vertex 4");
  expect_message<InvalidPath>([&] { (void)edge_edge(path, {-1, 1, 2, 3}); }, "no vertex -1");
  expect_message<InvalidOptions>([&] { (void)edge_edge(path, kAll, {-1.0}); }, "minimum separation is -1");
  expect_message<InvalidOptions>([&] { (void)edge_edge(path, kAll, {kNan}); }, "minimum separation");
  for (const double latest : {-1e-9, 1.5, kNan})
    expect_message<InvalidOptions>([&] { (void)edge_edge(path, kAll, {.latest = latest}); }, "latest time");
  for (const double tolerance : {0.0, -1e-9, 2.0, kNan})
    expect_message<InvalidOptions>([&] { (void)edge_edge(path, kAll, {.tolerance = tolerance}); }, "tolerance");
}

TEST(BadPath, RigidBodiesAreChecked) {
  const std::vector<Point> rest{{0, 0, 0}, {1, 0, 0}};
  expect_message<InvalidPath>([&] { RigidPath(rest, {0}, {RigidChain{}}); }, "2 rest positions and 1 numbers");
  expect_message<InvalidPath>([&] { RigidPath(rest, {0, 1}, {RigidChain{}}); }, "vertex 1 belongs to body 1");
  expect_message<InvalidPath>([&] { RigidPath(rest, {0, -1}, {RigidChain{}}); }, "vertex 1 belongs to body -1");
  expect_message<InvalidPath>(
      [&] {
        RigidPath({{0, kNan, 0}}, {0}, {RigidChain{}});
      },
      "vertex 0 of the path is not finite");
  expect_message<InvalidPath>(
      [&] {
        RigidPath(rest, {0, 0}, {RigidChain{}}, {{0, 0, 0}});
      },
      "2 rest positions and 1 at the end");
  const Pose bad{{0, 0, 0}, {kInfinity, 0, 0}};
  expect_message<InvalidPath>([&] { RigidPath(rest, {0, 0}, {interpolated_chain({}, bad)}); }, "a pose of body 0");
  // Bug: wherever it is, of three numbers std::hypot makes 0 where the second is none beside zeros.
  for (const Point& none : {Point{kNan, 0, 0}, Point{0, kNan, 0}, Point{0, 0, kNan}}) {
    const Pose nowhere{{0, 0, 0}, none};
    for (const RigidChain& chain :
         {chain_between(nowhere, {}), chain_between({}, nowhere), turned_chain(nowhere, {0, 0, 1}, {0, 0, 0})})
      expect_message<InvalidPath>([&] { RigidPath(rest, {0, 0}, {chain}); }, "a pose of body 0");
  }
}

}  // namespace
}  // namespace tamis::test

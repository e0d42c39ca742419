// The frame of the boxes holds every scene, of whatever size and wherever it is.
#include "search/bounds/packed_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "search/bounds/scene_vertices.hpp"
#include "search/bounds/shared_motion.hpp"

namespace tamis {
namespace {

// Bug: a scale that underflows or is cut off, so that coordinates are rounded by more than the boxes' margin.
TEST(PackedMotion, CoordinatesStayWithinTheFrame) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  const std::vector<Index> used{0, 1};
  for (const double size : {5e-324, 1e-300, 1.0, 1e300, kLargest / 4, kLargest}) {
    const std::vector<Point> start{{-size, 0, size}, {size, size, size}}, end{{size, 0, -size}, {0, -size, size}};
    PackedMotion motion;
    motion.assign({start, end}, used, {});
    for (const BoxVertex& vertex : motion.box_vertices)
      for (int i = 0; i < 6; ++i) EXPECT_LE(std::fabs(vertex.at[i]), 1) << size << ", coordinate " << i;
    if (size <= 1e-300) continue;
    EXPECT_NEAR(static_cast<double>(motion.box_vertices[1].at[0]), size * motion.frame.scale, 1e-6) << size;
  }
}

// Bug: the frame held a whole flight, however far, and its floats told little of what flies together.
TEST(PackedMotion, TheFrameGoesWithWhatGoesFarAsAWhole) {
  const std::vector<Index> used{0, 1};
  for (const double far : {1.0, 1e3, 1e9}) {
    const std::vector<Point> start{{-1, 0, 0}, {1, 0.5, 0}}, end{{far - 1, 0, -far}, {far + 1, 0.25, -far}};
    PackedMotion motion;
    motion.assign({start, end}, used, {});
    for (const BoxVertex& vertex : motion.box_vertices)
      for (int i = 0; i < 6; ++i) EXPECT_LE(std::fabs(vertex.at[i]), 1) << far << ", coordinate " << i;
    EXPECT_GE(motion.frame.scale, 0.25) << far;
    for (int i = 0; i < 6; ++i) {
      const auto axis = static_cast<std::size_t>(i % 3);
      const double apart = i < 3 ? start[1][axis] - start[0][axis] : end[1][axis] - end[0][axis];
      const float in_frame = motion.box_vertices[1].at[i] - motion.box_vertices[0].at[i];
      EXPECT_NEAR(static_cast<double>(in_frame), motion.frame.scale * apart, 0x1p-23) << far << ", coordinate " << i;
    }
    const auto way = motion.frame.displacement(motion.vertices[1]) - motion.frame.displacement(motion.vertices[0]);
    EXPECT_NEAR(way.y, -0.25 * motion.frame.scale, 0x1p-50) << far;
    EXPECT_NEAR(way.x, 0, 0x1p-50) << far;
  }
}

// Bug: a frame that holds one vertex far away makes a point of all others; or rounding hides more of that vertex than
// its radius says.
TEST(PackedMotion, OutliersLieOutsideWithinTheirRadius) {
  constexpr Index kCount = 400;
  std::vector<Index> used;
  std::vector<Point> start;
  for (Index v = 0; v < kCount; ++v) {
    used.push_back(v);
    start.push_back({0.1 * (v % 20), 0.1 * (v / 20), 0.001 * v});
  }
  for (const double far : {1e3, 1e5, 1e9, 1e12, 1e14, 1e300}) {
    std::vector<Point> end = start;
    start[123] = {far / 3, 1, 2};
    end[123] = {far / 7, 1, -far / 7};
    PackedMotion motion;
    motion.assign({start, end}, used, {});
    motion.assign_residuals(used, {});
    EXPECT_TRUE(motion.frame.has_outliers);
    EXPECT_TRUE(motion.view().box_separation.has_radii);
    EXPECT_GE(motion.frame.scale, 0.125) << far;
    EXPECT_LT(motion.spread, 1e-6f) << far;
    for (const Index v : used) {
      const BoxVertex& box = motion.box_vertices[static_cast<std::size_t>(v)];
      const BoxVertex& residual = motion.residuals[static_cast<std::size_t>(v)];
      EXPECT_EQ(motion.is_outlier(v), v == 123);
      const auto radius = static_cast<double>(box.at[BoxVertex::kRadius]);
      if (v != 123) {
        EXPECT_EQ(radius, 0) << far;
        EXPECT_EQ(residual.at[BoxVertex::kRadius], 0) << far;
        continue;
      }
      for (std::size_t k = 0; k < 6; ++k) {
        const Point& at = k < 3 ? start[123] : end[123];
        const double exact = (at[k % 3] - motion.frame.origin[k % 3]) * motion.frame.scale;
        if (std::fabs(exact) < 0x1p40)  // a third of the radius is what rounding to float may take
          EXPECT_LE(std::fabs(static_cast<double>(box.at[k]) - exact), radius / 3) << far;
        else
          EXPECT_GE(radius, 0x1p41) << far;
      }
      EXPECT_GE(static_cast<double>(residual.at[BoxVertex::kRadius]), std::min(1e12, 0.3 * far) * 0x1p-46) << far;
      for (const float x : residual.at) EXPECT_TRUE(std::isfinite(x)) << far;
    }
  }
}

/// A sheet of 20 vertices a row, `size` wide, at `place`.
std::vector<Point> sheet(int vertices, double size, double place) {
  std::vector<Point> points;
  for (int v = 0; v < vertices; ++v)
    points.push_back({place + size / 20 * (v % 20), size / 20 * (v / 20), 1e-3 * size});
  return points;
}

BoxFrame frame_of(const std::vector<Point>& start, const std::vector<Point>& end) {
  std::vector<Index> used(start.size());
  std::iota(used.begin(), used.end(), 0);
  return tamis::frame_of(StepVertices({start, end}, used), 0);
}

std::vector<Point> joined(std::vector<Point> points, const std::vector<Point>& others) {
  points.insert(points.end(), others.begin(), others.end());
  return points;
}

// Bug: a terrain of more vertices than the cloth on it decides where floats are dense, and the cloth becomes a point.
TEST(BoxFrame, IsAboutTheFinestWhereverMostVerticesAre) {
  const std::vector<Point> cloth = sheet(200, 1, 0), terrain = sheet(4000, 1e5, -5e4);
  for (const auto& scene : {joined(cloth, terrain), joined(terrain, cloth)}) {
    const BoxFrame frame = frame_of(scene, scene);
    EXPECT_TRUE(frame.has_outliers);
    EXPECT_GE(frame.scale, 0.25);
    EXPECT_LE(std::fabs(frame.origin[0]), 2);
  }
}

// Bug: a few slivers, or vertices that wait in one place until they are used, take the floats from the rest.
TEST(BoxFrame, IsNotThatOfSliversOrOfWhatWaits) {
  std::vector<Point> scene = sheet(1000, 1, 0);
  for (const std::size_t v : {109u, 328u})
    scene[v + 1] = {scene[v][0] + 1e-5, scene[v][1], scene[v][2]};  // both sampled
  std::vector<Point> waiting = joined(scene, std::vector<Point>(300, {1e6, 1e6, 1e6}));
  for (std::size_t v = 1000; v < 1300; ++v) waiting[v][0] += 1e-9 * static_cast<double>(v);
  EXPECT_FALSE(frame_of(scene, scene).has_outliers);
  const BoxFrame frame = frame_of(waiting, waiting);
  EXPECT_TRUE(frame.has_outliers);
  EXPECT_LE(std::fabs(frame.origin[0]), 2);
}

// Bug: the frame goes along with a part of the scene, and all that stands sweeps over that.
TEST(BoxFrame, GoesAlongOnlyWithMostVertices) {
  const std::vector<Point> fast = sheet(200, 1, 0), gone = sheet(200, 1, 1e3), city = sheet(1000, 100, -50);
  const BoxFrame frame = frame_of(joined(fast, city), joined(gone, city));
  EXPECT_EQ(frame.origin, frame.origin_at_end);
  EXPECT_FALSE(frame.has_outliers);
}

}  // namespace
}  // namespace tamis

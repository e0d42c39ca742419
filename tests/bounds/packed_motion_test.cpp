// The frame of the boxes holds every scene, of whatever size and wherever it is.
#include "bounds/packed_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

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

}  // namespace
}  // namespace tamis

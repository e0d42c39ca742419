#include "bvh/order_axes.hpp"

#include <algorithm>
#include <array>

namespace tamis {
namespace {

/// Six axes are looked at if points of a block differ in how far they go by this part of how far apart they are, as
/// areas: by its square (docs/history/performance.md, "What parts, by areas").
constexpr double kPartingWays = 0.5;

/// Of some numbers.
struct CoordinateRange {
  float low = kNowhere, high = -kNowhere;

  void include(float x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  double length() const { return static_cast<double>(high) - static_cast<double>(low); }
};

/// What a traversal's cost grows with.
double half_area(const std::array<CoordinateRange, 3>& box) {
  const double x = box[0].length(), y = box[1].length(), z = box[2].length();
  return x * y + y * z + z * x;
}

}  // namespace

OrderAxes axes_of_step(const PackedMotion& motion, std::span<const Index> points, Split split) {
  const std::size_t count = points.size() / kBlock;
  CenterStore store(count, 3);
  const Centers centers = store.view();
  for (std::size_t i = 0; i < count; ++i) {
    const Index vertex = centers.feature[i] = points[i * kBlock];
    const auto& at = motion.box_vertices[static_cast<std::size_t>(vertex)].at;
    for (int axis = 0; axis < 3; ++axis) centers.at[axis][i] = 0.5f * (at[axis] + at[3 + axis]);
  }
  order_in_space(centers, count, split, [] {});
  double apart = 0, apart_by_motion = 0;
  for (std::size_t first = 0; first < count; first += kBlock) {
    std::array<CoordinateRange, 3> where, how_far;
    for (std::size_t i = first; i < std::min(count, first + kBlock); ++i) {
      const auto& at = motion.box_vertices[static_cast<std::size_t>(centers.feature[i])].at;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        where[axis].include(0.5f * (at[axis] + at[3 + axis]));
        how_far[axis].include(0.5f * (at[3 + axis] - at[axis]));
      }
    }
    apart += half_area(where);
    apart_by_motion += half_area(how_far);
  }
  return {.axes = apart_by_motion > kPartingWays * kPartingWays * apart ? 6 : 3};
}

}  // namespace tamis

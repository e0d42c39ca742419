#include "bvh/order_axes.hpp"

#include <algorithm>

namespace tamis {
namespace {

/// Six axes are looked at if points of a block differ in how far they go by this part of how far apart they are
/// (docs/history/performance.md, "What chooses").
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

}  // namespace

int order_axes(const PackedMotion& motion, std::span<const Index> points, Split split) {
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
  for (std::size_t first = 0; first < count; first += kBlock)
    for (int axis = 0; axis < 3; ++axis) {
      CoordinateRange where, how_far;
      for (std::size_t i = first; i < std::min(count, first + kBlock); ++i) {
        const auto& at = motion.box_vertices[static_cast<std::size_t>(centers.feature[i])].at;
        where.include(0.5f * (at[axis] + at[3 + axis]));
        how_far.include(0.5f * (at[3 + axis] - at[axis]));
      }
      apart += where.length();
      apart_by_motion += how_far.length();
    }
  return apart_by_motion > kPartingWays * apart ? 6 : 3;
}

}  // namespace tamis

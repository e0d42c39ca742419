// Axis-aligned boxes at t=0 and at t=1, sixteen to a block. Interpolated linearly the two contain the feature at every
// t, so two features can touch only while their interpolated boxes meet (formulas: constant-axis and slab tests).
#pragma once
#include <array>
#include <cstdint>

namespace tamis {

inline constexpr int kBlock = 16;

/// Coordinates are in the frame of the boxes, within [-8,8]. An empty lane has low = kNowhere, high = -kNowhere, and
/// meets nothing; it is finite because differences of infinities are none.
inline constexpr float kNowhere = 1e30f;

/// [axis][lane].
struct alignas(64) BoxBlock {
  float low0[3][kBlock], high0[3][kBlock];
  float low1[3][kBlock], high1[3][kBlock];

  void clear(int lane) {
    for (int axis = 0; axis < 3; ++axis) {
      low0[axis][lane] = low1[axis][lane] = kNowhere;
      high0[axis][lane] = high1[axis][lane] = -kNowhere;
    }
  }
};

/// The vertices of sixteen features, [corner][lane]; -1 in an empty lane and past the last corner.
struct alignas(64) CornerBlock {
  std::int32_t vertex[3][kBlock];
};

}  // namespace tamis

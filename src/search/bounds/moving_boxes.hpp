// Axis-aligned boxes at t=0 and at t=1, sixteen to a block. Their linear interpolation contains the feature at every t.
// So two features can touch only while their interpolated boxes meet (formulas: constant-axis and slab tests).
#pragma once
#include <cstdint>

namespace tamis {

inline constexpr int kBlock = 16;

/// Boxes of features within the frame are no wider than this. A wider box reaches an outlier.
inline constexpr float kWidest = 16;

/// Coordinates are in the frame of the boxes, within [-8,8] except for outliers (BoxFrame). An empty lane has low =
/// kNowhere, high = -kNowhere, and meets nothing. kNowhere is finite because a difference of infinities is not a
/// number.
inline constexpr float kNowhere = 1e30f;

/// [axis][lane].
struct alignas(64) BoxBlock {
  float low0[3][kBlock], high0[3][kBlock];
  float low1[3][kBlock], high1[3][kBlock];
};

/// One box of a block: x y z at t=0, then at t=1, and two unused. The unused ones let compilers vectorize its loops.
struct MovingBox {
  static constexpr int kSize = 8;
  float low[kSize], high[kSize];

  MovingBox() {
    for (int i = 0; i < kSize; ++i) {
      low[i] = kNowhere;
      high[i] = -kNowhere;
    }
  }
  MovingBox(const BoxBlock& block, int lane) : MovingBox() {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = block.low0[axis][lane];
      high[axis] = block.high0[axis][lane];
      low[3 + axis] = block.low1[axis][lane];
      high[3 + axis] = block.high1[axis][lane];
    }
  }

  void include(const float (&other_low)[kSize], const float (&other_high)[kSize]) {
    for (int i = 0; i < kSize; ++i) {
      low[i] = other_low[i] < low[i] ? other_low[i] : low[i];
      high[i] = other_high[i] > high[i] ? other_high[i] : high[i];
    }
  }
  void include(const MovingBox& other) { include(other.low, other.high); }

  void store_to(BoxBlock& block, int lane) const {
    for (int axis = 0; axis < 3; ++axis) {
      block.low0[axis][lane] = low[axis];
      block.high0[axis][lane] = high[axis];
      block.low1[axis][lane] = low[3 + axis];
      block.high1[axis][lane] = high[3 + axis];
    }
  }
};

/// The vertices of sixteen features, [corner][lane]. Every entry is a valid vertex. An empty lane repeats the block's
/// first feature. Its box is empty, so it meets nothing. Corners past a feature's last corner repeat that corner.
/// Kernels gather and write whole vectors of lanes past the last feature. So every lane's vertices must be readable.
struct alignas(64) CornerBlock {
  std::int32_t vertex[3][kBlock];
};

}  // namespace tamis

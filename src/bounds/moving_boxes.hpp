// Axis-aligned boxes at t=0 and at t=1, sixteen to a block. Interpolated linearly the two contain the feature at every
// t, so two features can touch only while their interpolated boxes meet (formulas: constant-axis and slab tests).
#pragma once
#include <array>
#include <cstdint>
#include <limits>

namespace tamis {

inline constexpr int kBlock = 16;

/// [axis][lane]. An empty lane has low = +infinity, high = -infinity, and meets nothing.
struct alignas(64) BoxBlock {
  float low0[3][kBlock], high0[3][kBlock];
  float low1[3][kBlock], high1[3][kBlock];

  void clear(int lane) {
    for (int axis = 0; axis < 3; ++axis) {
      low0[axis][lane] = low1[axis][lane] = std::numeric_limits<float>::infinity();
      high0[axis][lane] = high1[axis][lane] = -std::numeric_limits<float>::infinity();
    }
  }
};

/// The vertices of sixteen features, [corner][lane]; -1 in an empty lane and past the last corner.
struct alignas(64) CornerBlock {
  std::int32_t vertex[3][kBlock];
};

}  // namespace tamis

// The vertices of a step as the hot loops want them: one cache line each in doubles for the solver, and floats in a
// common frame for the boxes.
#pragma once
#include <array>
#include <vector>

#include "tamis/step.hpp"

namespace tamis {

/// A vertex at t=0 and t=1: x y z, unused, x y z, unused.
struct alignas(64) PackedVertex {
  double at[8];
};

/// A vertex in the frame of the boxes, rounded to nearest: x y z at t=0, then at t=1, two unused; half a cache line.
struct alignas(32) BoxVertex {
  float at[8] = {};
};

/// box coordinate = (coordinate - origin) * scale: within [-1,1] for every vertex of the step. Scale is a power of
/// two and the origin follows the scene, so the unit of length changes no decision.
struct BoxFrame {
  std::array<double, 3> origin;
  double scale;
  /// Added on each side of a box: rounding to float is off by 2^-25, the subtraction by 2^-53, and the box's own
  /// subtraction of the margin by 2^-25; plus half the minimum separation.
  float margin;
};

struct PackedMotion {
  std::vector<PackedVertex> vertices;
  std::vector<BoxVertex> box_vertices;
  BoxFrame frame;

  /// `min_separation` >= 0 in the unit of the step. Vertices outside `used` are left as they are.
  void assign(const Step& step, std::span<const Index> used, double min_separation);
  std::uint64_t memory_bytes() const {
    return vertices.capacity() * sizeof(PackedVertex) + box_vertices.capacity() * sizeof(BoxVertex);
  }
};

}  // namespace tamis

// The vertices of a step as the hot loops want them: one cache line each in doubles for the solver, and floats in a
// common frame for the boxes.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "motion/separations.hpp"
#include "tamis/step.hpp"

namespace tamis {

/// A vertex at t=0 and t=1: x y z, its radius (Separations), x y z, unused.
struct alignas(64) PackedVertex {
  double at[8];
};

/// What stands in the second half of a BoxVertex, and of the boxes made of it.
enum class SecondHalf : std::uint8_t {
  end,           ///< the position at t=1
  displacement,  ///< the way from t=0 to t=1, for questions about distances at t=0 and speeds
};

/// A vertex in the frame of the boxes, rounded to nearest: x y z at t=0, then its second half, its radius (rounded up),
/// one unused; half a cache line.
struct alignas(32) BoxVertex {
  static constexpr int kRadius = 6;
  float at[8] = {};
};

/// box coordinate = (coordinate - origin) * scale: within [-1,1] for every vertex of the step. Scale is a power of
/// two and the origin follows the scene, so the unit of length changes no decision.
struct BoxFrame {
  std::array<double, 3> origin;
  double scale;
  /// Added on each side of a box: rounding to float is off by 2^-25, the subtraction by 2^-53, and the box's own
  /// subtraction of the margin by 2^-25; plus half the fixed separation. A vertex' radius comes on top.
  float margin;
  /// The same for displacements, times the displacement: rounding to float is off by 2^-24 of it, the box's own
  /// subtraction by as much.
  static constexpr float kRelativeMargin = 0x1p-22f;
  /// And added to that: the speed of a single pair (solve/kept_distance.hpp) is rounded up by at most 2 * 40 * 2^-53 of
  /// its three sizes, each at most 2 here: below 2^-44, and two boxes' margins add up. No bound from boxes may be
  /// sharper.
  static constexpr float kLeastMargin = 0x1p-44f;
};

/// The separation of a pair: a fixed distance, and if there are any the radii that stand beside the vertices.
struct PairSeparation {
  double fixed = 0;
  bool has_radii = false;

  bool any() const { return fixed > 0 || has_radii; }
};

/// The same in the frame of the boxes, with what rounding the vertices to floats may hide: the margins of two boxes.
struct BoxSeparation {
  float fixed;
  bool has_radii;
};

struct PackedMotion {
  std::vector<PackedVertex> vertices;
  std::vector<BoxVertex> box_vertices;
  BoxFrame frame;
  SecondHalf second_half = SecondHalf::end;
  Separations separations;

  /// Vertices outside `used` are left as they are.
  void assign(const Step& step, std::span<const Index> used, const Separations& separations,
              SecondHalf second_half = SecondHalf::end);
  /// What the kernels need of the separations.
  PairSeparation pair_separation() const { return {separations.fixed, !separations.radii.empty()}; }
  BoxSeparation box_separation() const { return {2 * frame.margin, !separations.radii.empty()}; }
  std::uint64_t memory_bytes() const {
    return vertices.capacity() * sizeof(PackedVertex) + box_vertices.capacity() * sizeof(BoxVertex);
  }
};

/// What boxes of a motion's vertices are widened by, in the order of a BoxVertex: so much, so much of the box's size,
/// and (1 or 0) the largest radius of its vertices.
struct BoxMargins {
  float fixed[8] = {}, relative[8] = {}, radius[8] = {};

  explicit BoxMargins(const PackedMotion& motion) {
    const bool moves = motion.second_half == SecondHalf::displacement;
    for (int i = 0; i < 6; ++i) {
      const bool is_displacement = moves && i >= 3;
      fixed[i] = is_displacement ? BoxFrame::kLeastMargin : motion.frame.margin;
      relative[i] = is_displacement ? BoxFrame::kRelativeMargin : 0;
      radius[i] = is_displacement ? 0 : 1;
    }
  }
};

}  // namespace tamis

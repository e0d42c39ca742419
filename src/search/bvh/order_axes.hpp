// The coordinates by which a tree orders the features of a step: positions at some time, or also displacements.
#pragma once
#include "search/bounds/moving_boxes.hpp"
#include "search/bounds/packed_motion.hpp"
#include "search/bvh/spatial_order.hpp"

namespace tamis {

/// Positions at `time`; if the weight is not zero, also displacements times that.
struct OrderAxes {
  float time = 0.5f;
  float displacement_weight = 0;

  int count() const { return displacement_weight > 0 ? 6 : 3; }
  /// The mean of some vertices, by count() axes. `sum`: of their coordinates, x y z at t=0, then at t=1.
  template <int axes>
  Center<axes> center(const float* sum, float vertices, Index feature) const {
    Center<axes> center;
    center.feature = feature;
    for (int axis = 0; axis < 3; ++axis) {
      const float displacement = sum[3 + axis] - sum[axis];
      center.at[axis] = (sum[axis] + time * displacement) / vertices;
      if constexpr (axes == 6) center.at[3 + axis] = displacement_weight * displacement / vertices;
    }
    return center;
  }
};

/// Which part of the step a question's search visits most, so the trees' order should serve it.
enum class LooksAt : std::uint8_t {
  whole_step,
  start,      ///< poses, and `earliest`: where the step is long its first contact comes early
  distances,  ///< step lengths: distances at the start, and how far they shrink until the end
};

/// The axes whose order serves the question best, judged by every sixteenth of `points`. For `earliest` of
/// cloth-ball x10 the order of the start takes 52 ms, the order halfway 77.
OrderAxes order_axes(const PackedMotion& motion, std::span<const Index> points, LooksAt looks_at);

}  // namespace tamis

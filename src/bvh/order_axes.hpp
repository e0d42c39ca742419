// By what the features of a step are put in order: by where they are at some time, or also by how far they go.
#pragma once
#include "bounds/moving_boxes.hpp"
#include "bounds/packed_motion.hpp"
#include "bvh/spatial_order.hpp"

namespace tamis {

/// By where features are at `time`; with six axes also by how far they go.
struct OrderAxes {
  float time = 0.5f;
  int axes = 3;
};

/// For what looks at the start of the step, or at little else.
inline constexpr OrderAxes kAxesOfStart{0, 3};
/// For what looks at the whole step: halfway; by six axes where points that are near each other then come from far
/// apart. Judged by every sixteenth of `points`.
OrderAxes axes_of_step(const PackedMotion& motion, std::span<const Index> points, Split split);

}  // namespace tamis

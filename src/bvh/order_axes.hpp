// By what the features of a step are put in order: by where they are, or also by how far they go.
#pragma once
#include "bounds/moving_boxes.hpp"
#include "bounds/packed_motion.hpp"
#include "bvh/spatial_order.hpp"

namespace tamis {

/// Three axes, of where features are halfway through the step; or six, of how far they go as well, where points that
/// are near each other then come from far apart. Judged by every sixteenth of `points`.
int order_axes(const PackedMotion& motion, std::span<const Index> points, Split split);

}  // namespace tamis

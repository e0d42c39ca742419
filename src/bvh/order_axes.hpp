// By what the features of a step are put in order: by where they are at some time, or also by how far they go.
#pragma once
#include "bounds/moving_boxes.hpp"
#include "bounds/packed_motion.hpp"
#include "bvh/spatial_order.hpp"

namespace tamis {

/// By where features are at `time`; unless `way` is zero also by that part of how far they go.
struct OrderAxes {
  float time = 0.5f;
  float way = 0;

  int count() const { return way > 0 ? 6 : 3; }
};

/// What a question looks at most.
enum class LooksAt : std::uint8_t {
  whole_step,
  start,      ///< and no more of the step than until a first contact, which comes early where the step is long
  distances,  ///< of the start, and what becomes of them until the end
};

/// The order that serves it best, judged by every sixteenth of `points` (docs/history/performance.md, "What is near at
/// the start").
OrderAxes order_axes(const PackedMotion& motion, std::span<const Index> points, LooksAt looks_at, Split split);

}  // namespace tamis

// Computes the sixteen boxes of a leaf block in lanes, from vertices that are gathered by index.
#pragma once
#include "numbers/lanes.hpp"
#include "search/bvh/block_tree.hpp"

namespace tamis::TAMIS_ISA {

/// Lower and upper ends of one box a lane, for each column of BoxVertex.
struct BoxEnds {
  FloatLanes low[BoxVertex::kRadius + 1], high[BoxVertex::kRadius + 1];

  void include(const FloatLanes (&columns)[BoxVertex::kRadius + 1]) {
    for (int k = 0; k <= BoxVertex::kRadius; ++k) {
      low[k] = min(low[k], columns[k]);
      high[k] = max(high[k], columns[k]);
    }
  }
  /// Widens each box by the fixed margin, the relative margin times its largest |coordinate| along the axis, and its
  /// largest radius.
  void widen(const BoxMargins& margins) {
    const FloatLanes radius = high[BoxVertex::kRadius];
    for (int k = 0; k < BoxVertex::kRadius; ++k) {
      const FloatLanes size = max(-low[k], high[k]);
      const FloatLanes margin = FloatLanes(margins.fixed) + FloatLanes(margins.relative) * size + radius;
      low[k] = low[k] - margin;
      high[k] = high[k] + margin;
    }
  }
};

inline void bound_leaf(const BoxVertex* vertices, const CornerBlock& block, int corners, int in_use,
                       const BoxMargins& margins, BoxBlock& boxes, MovingBox& hull) {
  for (int first = 0; first < kBlock; first += kFloatLanes) {
    BoxEnds ends;
    load_columns(&vertices->at, block.vertex[0] + first, ends.low);
    for (int k = 0; k <= BoxVertex::kRadius; ++k) ends.high[k] = ends.low[k];
    for (int corner = 1; corner < corners; ++corner) {
      FloatLanes columns[BoxVertex::kRadius + 1];
      load_columns(&vertices->at, block.vertex[corner] + first, columns);
      ends.include(columns);
    }
    ends.widen(margins);
    // Empty lanes repeat the block's first feature, so they change no hull. Their boxes are stored as empty.
    const auto is_used = xsimd::to_float(counting_from(first)) < FloatLanes(static_cast<float>(in_use));
    for (int k = 0; k < BoxVertex::kRadius; ++k) {
      const auto put = [&](const FloatLanes& lanes, float nowhere, float(&to)[kBlock]) {
        select(is_used, lanes, FloatLanes(nowhere)).store_aligned(to + first);
      };
      put(ends.low[k], kNowhere, k < 3 ? boxes.low0[k] : boxes.low1[k - 3]);
      put(ends.high[k], -kNowhere, k < 3 ? boxes.high0[k] : boxes.high1[k - 3]);
      const float low = least(ends.low[k]), high = greatest(ends.high[k]);
      hull.low[k] = low < hull.low[k] ? low : hull.low[k];
      hull.high[k] = high > hull.high[k] ? high : hull.high[k];
    }
  }
}

}  // namespace tamis::TAMIS_ISA

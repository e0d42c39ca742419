// Sixteen moving boxes against one: in which of them may a pair of features lose more of its distance than it may?
#pragma once
#include "kernels/box_overlap.hpp"

namespace tamis::TAMIS_ISA {

/// Boxes that move, with the drifts of their hulls from t=0 on. Bits of the lanes in which a pair of features may, by
/// search.near, end the step; where bits are set, `t_in` and `t_out` get the times at which boxes are that near. A pair
/// can end it only
/// - if its reserve, and so the boxes' gap at t=0, is at most the reach times its speed, which is at most the largest
///   difference of drifts; squares of lengths are compared: gaps are multiples of 2^-47, because boxes have margins,
///   so that nothing that matters underflows;
/// - while the boxes are as near as the fraction of the largest reserve of such a pair, or of any pair between the
///   farthest corners. Boxes are wider by the minimum separation, which so is in all gaps.
struct NearBoxes {
  struct Sixteen {
    Sixteen(const TreeView& tree, int level, int node, const Search& search)
        : block(tree.levels[level][node]), near(search.near) {
      // Features move at most as fast as their leaf's hull.
      const BoxBlock& drifts = level > 0 ? tree.drifts[level][node] : tree.drifts[1][node / kBlock];
      for (int axis = 0; axis < 3; ++axis)
        for (int lane = 0; lane < kBlock; ++lane) {
          const int from = level > 0 ? lane : node % kBlock;
          low[axis][lane] = drifts.low1[axis][from];
          high[axis][lane] = drifts.high1[axis][from];
        }
    }
    const BoxBlock& block;
    const NearRule& near;
    alignas(64) float low[3][kBlock], high[3][kBlock];  ///< of drifts
  };

  struct One : MovingBoxes::One {
    One(const Sixteen& boxes, int lane) : MovingBoxes::One(boxes.block, lane) {
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = FloatLanes(boxes.low[axis][lane]);
        high[axis] = FloatLanes(boxes.high[axis][lane]);
      }
    }
    FloatLanes low[3], high[3];
  };

  [[gnu::always_inline]] static unsigned meet(const Sixteen& boxes, const One& one, float* t_in, float* t_out) {
    const FloatLanes zero(0.0f), reach(boxes.near.reach);
    const BoxBlock& b = boxes.block;
    unsigned result = 0;
    for (int first = 0; first < kBlock; first += kFloatLanes) {
      const auto load = [&](const float* lanes) { return FloatLanes::load_aligned(lanes + first); };
      FloatLanes gap2(0.0f), way2(0.0f), far2(0.0f), size(0.0f);
      for (int axis = 0; axis < 3; ++axis) {
        const auto above = load(b.low0[axis]) - one.high0[axis], below = one.low0[axis] - load(b.high0[axis]);
        const auto way = max(load(boxes.high[axis]) - one.low[axis], one.high[axis] - load(boxes.low[axis]));
        const auto apart = max(max(above, below), zero), reached = reach * max(way, zero);
        const auto far0 = max(-min(above, below), zero);
        const auto far1 = max(load(b.high1[axis]) - one.low1[axis], one.high1[axis] - load(b.low1[axis]));
        gap2 = gap2 + apart * apart;
        way2 = way2 + reached * reached;
        far2 = far2 + far0 * far0;
        size = max(size, max(far0, far1));
      }
      const auto kept = FloatLanes(boxes.near.fraction) * sqrt(min(far2, way2)) + FloatLanes(kRoomOfBoxes) * size;
      TimeClip<FloatLanes> clip({zero, FloatLanes(boxes.near.t_limit)});
      for (int axis = 0; axis < 3; ++axis) {
        clip.cut_positive(load(b.low0[axis]) - one.high0[axis] - kept, load(b.low1[axis]) - one.high1[axis] - kept);
        clip.cut_positive(one.low0[axis] - load(b.high0[axis]) - kept, one.low1[axis] - load(b.high1[axis]) - kept);
      }
      const auto time = clip.rest();
      time.t_in.store_aligned(t_in + first);
      time.t_out.store_aligned(t_out + first);
      result |= bits((gap2 <= way2) & (time.t_in <= time.t_out)) << first;
    }
    return result;
  }

 private:
  /// error_bounds::kRoomToAdvance for every pair within two boxes: its three sizes are together at most three times the
  /// largest extent of the two boxes at either end of the step; 4 covers the rounding of all the rest.
  static constexpr float kRoomOfBoxes = 4 * static_cast<float>(error_bounds::kRoomToAdvance);
};

}  // namespace tamis::TAMIS_ISA

// Sixteen moving boxes against one: in which of them, and when, may the two meet? Two answers: of boxes that move, and
// of what they sweep over, which costs a third and says as much where the motion is short. And another question: which
// are near, as fast as they move?
#pragma once
#include "kernels/kernels.hpp"
#include "motion/time_clip.hpp"
#include "numerics/lanes.hpp"

namespace tamis::TAMIS_ISA {

/// Bits of the lanes whose boxes meet before `t_limit`; where bits are set, `t_in` and `t_out` get the times.
struct MovingBoxes {
  struct Sixteen {
    Sixteen(const TreeView& tree, int level, int node, const Search& search)
        : block(tree.levels[level][node]), t_limit(search.t_limit) {}
    const BoxBlock& block;
    const float t_limit;
  };

  /// One box in every lane.
  struct One {
    One(const BoxBlock& block, int lane) {
      for (int axis = 0; axis < 3; ++axis) {
        low0[axis] = FloatLanes(block.low0[axis][lane]);
        high0[axis] = FloatLanes(block.high0[axis][lane]);
        low1[axis] = FloatLanes(block.low1[axis][lane]);
        high1[axis] = FloatLanes(block.high1[axis][lane]);
      }
    }
    One(const Sixteen& boxes, int lane) : One(boxes.block, lane) {}
    FloatLanes low0[3], high0[3], low1[3], high1[3];
  };

  [[gnu::always_inline]] static unsigned meet(const Sixteen& boxes, const One& one, float* t_in, float* t_out) {
    unsigned result = 0;
    for (int first = 0; first < kBlock; first += kFloatLanes) {
      const auto load = [&](const float* lanes) { return FloatLanes::load_aligned(lanes + first); };
      const BoxBlock& b = boxes.block;
      TimeClip<FloatLanes> clip({FloatLanes(0.0f), FloatLanes(boxes.t_limit)});
      for (int axis = 0; axis < 3; ++axis) {
        clip.cut_positive(load(b.low0[axis]) - one.high0[axis], load(b.low1[axis]) - one.high1[axis]);
        clip.cut_positive(one.low0[axis] - load(b.high0[axis]), one.low1[axis] - load(b.high1[axis]));
      }
      const auto time = clip.rest();
      time.t_in.store_aligned(t_in + first);
      time.t_out.store_aligned(t_out + first);
      result |= bits(time.t_in <= time.t_out) << first;
    }
    return result;
  }
};

/// The same of the boxes swept until `t_limit`: more lanes may meet, and always from the start on.
struct SweptBoxes {
  struct Sixteen {
    Sixteen(const TreeView& tree, int level, int node, const Search& search) : t_limit(search.t_limit) {
      const BoxBlock& block = tree.levels[level][node];
      // Coordinates are within [-8,8]: the three roundings below are off by at most 40 * 2^-24.
      const FloatLanes t(t_limit), margin(0x1p-18f);
      for (int axis = 0; axis < 3; ++axis)
        for (int first = 0; first < kBlock; first += kFloatLanes) {
          const auto load = [&](const float* lanes) { return FloatLanes::load_aligned(lanes + first); };
          const auto l0 = load(block.low0[axis]), h0 = load(block.high0[axis]);
          const auto l = l0 + t * (load(block.low1[axis]) - l0), h = h0 + t * (load(block.high1[axis]) - h0);
          (min(l, l0) - margin).store_aligned(low[axis] + first);
          (max(h, h0) + margin).store_aligned(high[axis] + first);
        }
    }
    alignas(64) float low[3][kBlock], high[3][kBlock];
    const float t_limit;
  };

  struct One {
    One(const Sixteen& boxes, int lane) {
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = FloatLanes(boxes.low[axis][lane]);
        high[axis] = FloatLanes(boxes.high[axis][lane]);
      }
    }
    FloatLanes low[3], high[3];
  };

  [[gnu::always_inline]] static unsigned meet(const Sixteen& boxes, const One& one, float* t_in, float* t_out) {
    unsigned result = 0;
    for (int first = 0; first < kBlock; first += kFloatLanes) {
      const auto load = [&](const float* lanes) { return FloatLanes::load_aligned(lanes + first); };
      // The largest gap: cheaper than six masks.
      FloatLanes gap = max(load(boxes.low[0]) - one.high[0], one.low[0] - load(boxes.high[0]));
      for (int axis = 1; axis < 3; ++axis)
        gap = max(gap, max(load(boxes.low[axis]) - one.high[axis], one.low[axis] - load(boxes.high[axis])));
      FloatLanes(0.0f).store_aligned(t_in + first);
      FloatLanes(boxes.t_limit).store_aligned(t_out + first);
      result |= bits(gap <= FloatLanes(0.0f)) << first;
    }
    return result;
  }
};

}  // namespace tamis::TAMIS_ISA

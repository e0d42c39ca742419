// Sixteen moving boxes against one: in which of them, and when, may the two meet?
#pragma once
#include "bounds/moving_boxes.hpp"
#include "motion/time_clip.hpp"
#include "numerics/lanes.hpp"

namespace tamis::TAMIS_ISA {

/// One box in every lane.
struct WideBox {
  FloatLanes low0[3], high0[3], low1[3], high1[3];

  WideBox(const BoxBlock& block, int lane) {
    for (int axis = 0; axis < 3; ++axis) {
      low0[axis] = FloatLanes(block.low0[axis][lane]);
      high0[axis] = FloatLanes(block.high0[axis][lane]);
      low1[axis] = FloatLanes(block.low1[axis][lane]);
      high1[axis] = FloatLanes(block.high1[axis][lane]);
    }
  }
};

/// Bits of the lanes whose boxes meet `box` before `t_limit`; where bits are set, `t_in` and `t_out` get the times.
inline unsigned overlap(const BoxBlock& block, const WideBox& box, const FloatLanes& t_limit, float* t_in,
                        float* t_out) {
  unsigned result = 0;
  for (int first = 0; first < kBlock; first += kFloatLanes) {
    TimeClip<FloatLanes> clip({FloatLanes(0.0f), t_limit});
    for (int axis = 0; axis < 3; ++axis) {
      clip.cut_positive(FloatLanes::load_aligned(block.low0[axis] + first) - box.high0[axis],
                        FloatLanes::load_aligned(block.low1[axis] + first) - box.high1[axis]);
      clip.cut_positive(box.low0[axis] - FloatLanes::load_aligned(block.high0[axis] + first),
                        box.low1[axis] - FloatLanes::load_aligned(block.high1[axis] + first));
    }
    const auto time = clip.rest();
    const unsigned mask = bits(time.t_in <= time.t_out);
    time.t_in.store_aligned(t_in + first);
    time.t_out.store_aligned(t_out + first);
    result |= mask << first;
  }
  return result;
}

}  // namespace tamis::TAMIS_ISA

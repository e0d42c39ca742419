// Sixteen moving boxes against one: in which of them, and when, may the two meet?
#pragma once
#include "bounds/moving_boxes.hpp"
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

/// Gaps on one side of one axis at t=0 and t=1: while the line between them is positive the boxes are apart.
struct Gap {
  FloatLanes at0, at1;
};

/// Gaps are off by 2^-24 of themselves, the quotient by 2^-22; 2^-20 is given.
inline void cut_positive(const Gap& gap, FloatLanes& t_in, FloatLanes& t_out) {
  const FloatLanes zero(0.0f), root = gap.at0 / (gap.at0 - gap.at1);
  t_in = select(gap.at0 > zero, max(t_in, root * FloatLanes(1 - 0x1p-20f)), t_in);
  t_out = select(gap.at1 > zero, min(t_out, root * FloatLanes(1 + 0x1p-20f)), t_out);
}

/// Bits of the lanes whose boxes meet `box` before `t_limit`; where bits are set, `t_in` and `t_out` get the times.
inline unsigned overlap(const BoxBlock& block, const WideBox& box, const FloatLanes& t_limit, float* t_in,
                        float* t_out) {
  unsigned result = 0;
  for (int first = 0; first < kBlock; first += kFloatLanes) {
    Gap gaps[6];
    FloatLanes apart(-1.0f);
    for (int axis = 0; axis < 3; ++axis) {
      gaps[2 * axis] = {FloatLanes::load_aligned(block.low0[axis] + first) - box.high0[axis],
                        FloatLanes::load_aligned(block.low1[axis] + first) - box.high1[axis]};
      gaps[2 * axis + 1] = {box.low0[axis] - FloatLanes::load_aligned(block.high0[axis] + first),
                            box.low1[axis] - FloatLanes::load_aligned(block.high1[axis] + first)};
    }
    for (const Gap& gap : gaps) apart = max(apart, min(gap.at0, gap.at1));
    const auto together = apart <= FloatLanes(0.0f);
    if (!bits(together)) continue;
    FloatLanes in(0.0f), out = t_limit;
    for (const Gap& gap : gaps) cut_positive(gap, in, out);
    const unsigned mask = bits(together & (in <= out));
    in.store_aligned(t_in + first);
    out.store_aligned(t_out + first);
    result |= mask << first;
  }
  return result;
}

}  // namespace tamis::TAMIS_ISA

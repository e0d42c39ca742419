// How far apart at the start of a step features may be that end it, by the residuals of the boxes they are in; and
// which are no farther apart.
#pragma once
#include "kernels/box_overlap.hpp"

namespace tamis::TAMIS_ISA {

[[gnu::always_inline]] inline void add_square(FloatLanes& sum, const FloatLanes& x) { sum = sum + x * x; }

/// Of two boxes: the square of how far their residuals can part them. `a(k)`, `b(k)`: bound k of the boxes in lanes;
/// lower ends of residuals are from `residual` on, all upper ends `high` behind the lower ones.
template <int residual, int high, class A, class B>
[[gnu::always_inline]] inline FloatLanes greatest_way2(const A& a, const B& b) {
  FloatLanes way2(0.0f);
  for (int k = residual; k < residual + 3; ++k)
    add_square(way2, max(max(b(high + k) - a(k), a(high + k) - b(k)), FloatLanes(0.0f)));
  return way2;
}

/// How far apart along an axis two features can be, of a clearance whose square is at most so much.
[[gnu::always_inline]] inline FloatLanes reach_of(const FloatLanes& clearance2) {
  return xsimd::sqrt(clearance2) * FloatLanes(1 + 0x1p-20f);
}

/// Of the features of a leaf block at t=0: summed over the axes, how far they extend.
inline float extent(const Search& search, int block) {
  const BoxBlock& hulls = search.a.levels[1][block / kBlock];
  const int lane = block % kBlock;
  float sum = 0;
  for (int axis = 0; axis < 3; ++axis) sum += hulls.high0[axis][lane] - hulls.low0[axis][lane];
  return sum;
}

/// Bits of the sixteen whose boxes at t=0 are, along each axis, within reach of the one in that lane.
inline unsigned within_reach(const BoxBlock& one, int lane, const BoxBlock& sixteen, float reach) {
  unsigned mask = 0;
  for_sixteen_lanes([&](int first) {
    const auto a = [&](int k) { return FloatLanes(k < 3 ? one.low0[k][lane] : one.high0[k - 3][lane]); };
    const auto b = [&](int k) {
      return FloatLanes::load_aligned((k < 3 ? sixteen.low0[k] : sixteen.high0[k - 3]) + first);
    };
    mask |= bits(largest_gap(a, b) <= FloatLanes(reach)) << first;
  });
  return mask;
}

}  // namespace tamis::TAMIS_ISA

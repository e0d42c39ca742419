// Reach: how far apart features in two boxes can be at t=0 and still end the step, by their residuals. Also finds the
// boxes within that reach.
#pragma once
#include "numbers/platform.hpp"
#include "search/kernels/box_overlap.hpp"

namespace tamis::TAMIS_ISA {

TAMIS_ALWAYS_INLINE void add_square(FloatLanes& sum, const FloatLanes& x) { sum = sum + x * x; }

/// The square of the largest difference of two boxes' residuals. `a(k)`, `b(k)`: bound k of the boxes in lanes; lower
/// ends of residuals are from `residual` on, upper ends `high` behind the lower ones.
template <int residual, int high, class A, class B>
TAMIS_ALWAYS_INLINE FloatLanes greatest_residual2(const A& a, const B& b) {
  FloatLanes residual2(0.0f);
  for (int k = residual; k < residual + 3; ++k)
    add_square(residual2, max(max(b(high + k) - a(k), a(high + k) - b(k)), FloatLanes(0.0f)));
  return residual2;
}

/// The reach along an axis, rounded up, of features with at most this clearance^2.
TAMIS_ALWAYS_INLINE FloatLanes reach_of(const FloatLanes& clearance2) {
  return xsimd::sqrt(clearance2) * FloatLanes(1 + 0x1p-20f);
}

/// The extent at t=0 of a leaf block's features, summed over the axes.
inline float extent(const Search& search, int block) {
  const BoxBlock& hulls = search.a.levels[1][block / kBlock];
  const int lane = block % kBlock;
  float sum = 0;
  for (int axis = 0; axis < 3; ++axis) sum += hulls.high0[axis][lane] - hulls.low0[axis][lane];
  return sum;
}

/// Bits of the sixteen boxes that at t=0 are, along each axis, within reach of box `lane` of `one`.
inline unsigned within_reach(const BoxBlock& one, int lane, const BoxBlock& sixteen, float reach) {
  return bits_of_sixteen([&](int first) {
    const auto a = [&](int k) { return FloatLanes(k < 3 ? one.low0[k][lane] : one.high0[k - 3][lane]); };
    const auto b = [&](int k) { return lanes_of(k < 3 ? sixteen.low0[k] : sixteen.high0[k - 3], first); };
    return largest_gap(a, b) <= FloatLanes(reach);
  });
}

}  // namespace tamis::TAMIS_ISA

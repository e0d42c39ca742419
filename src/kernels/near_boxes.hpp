// Moving boxes and drifts: in which of them may a pair of features lose more of its distance than it may?
#pragma once
#include "kernels/box_overlap.hpp"
#include "motion/time_clip.hpp"

namespace tamis::TAMIS_ISA {

/// Boxes that move, with the drifts of their hulls from t=0 on. A pair of features can, by search.near, end the step
/// only
/// - if its reserve, and so the boxes' gap at t=0, is at most the reach times its speed, which is at most the largest
///   difference of drifts; squares of lengths are compared: gaps are multiples of 2^-47, because boxes have margins,
///   so that nothing that matters underflows;
/// - while the boxes are as near as the fraction of the largest reserve of such a pair, or of any pair between the
///   farthest corners. Boxes are wider by the minimum separation, which so is in all gaps.
class NearBoxes {
 public:
  using Bounds = BoundBlock<18>;  ///< x y z at t=0, at t=1, of drifts

  NearBoxes(const Search& search, int) : near_(search.near) {}

  void bound(const TreeView& tree, int level, int node, Bounds& bounds) const {
    const BoxBlock& block = tree.levels[level][node];
    __builtin_memcpy(bounds.at[kStart], block.low0, sizeof(block.low0));
    __builtin_memcpy(bounds.at[kEnd], block.low1, sizeof(block.low1));
    __builtin_memcpy(bounds.at[kHigh + kStart], block.high0, sizeof(block.high0));
    __builtin_memcpy(bounds.at[kHigh + kEnd], block.high1, sizeof(block.high1));
    // Features move at most as fast as their leaf's hull.
    const BoxBlock& drifts = level > 0 ? tree.drifts[level][node] : tree.drifts[1][node / kBlock];
    for (int axis = 0; axis < 3; ++axis)
      for (int lane = 0; lane < kBlock; ++lane) {
        const int from = level > 0 ? lane : node % kBlock;
        bounds.at[kDrift + axis][lane] = drifts.low1[axis][from];
        bounds.at[kHigh + kDrift + axis][lane] = drifts.high1[axis][from];
      }
  }

  /// `a(k)`, `b(k)`: bound k of the boxes in lanes.
  template <class A, class B>
  [[gnu::always_inline]] auto meet(const A& a, const B& b) const {
    const FloatLanes zero(0.0f), reach(near_.reach);
    const auto above = [&](int k) { return b(k) - a(kHigh + k); };
    const auto below = [&](int k) { return a(k) - b(kHigh + k); };
    FloatLanes gap2(0.0f), way2(0.0f), far2(0.0f), size(0.0f);
    for (int axis = 0; axis < 3; ++axis) {
      const int start = kStart + axis, end = kEnd + axis, drift = kDrift + axis;
      const auto way = -min(above(drift), below(drift));
      const auto apart = max(max(above(start), below(start)), zero), reached = reach * max(way, zero);
      const auto far0 = max(-min(above(start), below(start)), zero), far1 = -min(above(end), below(end));
      gap2 = gap2 + apart * apart;
      way2 = way2 + reached * reached;
      far2 = far2 + far0 * far0;
      size = max(size, max(far0, far1));
    }
    const auto kept = FloatLanes(near_.fraction) * sqrt(min(far2, way2)) + FloatLanes(kRoomOfBoxes) * size;
    TimeClip<FloatLanes> clip({zero, FloatLanes(near_.t_limit)});
    for (int axis = 0; axis < 3; ++axis) {
      clip.cut_positive(above(kStart + axis) - kept, above(kEnd + axis) - kept);
      clip.cut_positive(below(kStart + axis) - kept, below(kEnd + axis) - kept);
    }
    const auto time = clip.rest();
    return (gap2 <= way2) & (time.t_in <= time.t_out);
  }

  float t_limit() const { return near_.t_limit; }

 private:
  static constexpr int kStart = 0, kEnd = 3, kDrift = 6, kHigh = 9;
  /// Of the boxes at both ends of the step.
  static constexpr auto kRoomOfBoxes = static_cast<float>(error_bounds::kRoomOfBoxes);

  const NearRule near_;
};

}  // namespace tamis::TAMIS_ISA

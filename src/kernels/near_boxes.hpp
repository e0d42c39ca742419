// Moving boxes and drifts: in which of them may a pair of features lose more of its distance than it may?
#pragma once
#include "kernels/box_overlap.hpp"

namespace tamis::TAMIS_ISA {

/// Boxes that move, with the drifts of what they hold from t=0 on. A pair of features can, by search.near, end the step
/// only
/// - if its reserve, and so the boxes' gap at t=0, is at most the reach times its speed, which is at most the largest
///   difference of drifts; squares of lengths are compared: gaps are multiples of 2^-47, because boxes have margins,
///   so that nothing that matters underflows;
/// - while the boxes are as near as the fraction of the largest reserve of such a pair, or of any pair between the
///   farthest corners. Boxes are wider by the minimum separation, which so is in all gaps.
class NearBoxes {
 public:
  using Bounds = BoundBlock<18>;  ///< x y z at t=0, at t_limit, of drifts

  NearBoxes(const Search& search, int) : near_(search.near) {}

  void bound(const TreeView& tree, int level, int node, Bounds& bounds) const {
    Ends::store(tree.levels[level][node], near_.t_limit, bounds);
    const BoxBlock& drifts = tree.drifts[level][node];
    __builtin_memcpy(bounds.at[kDrift], drifts.low1, sizeof(drifts.low1));
    __builtin_memcpy(bounds.at[kHigh + kDrift], drifts.high1, sizeof(drifts.high1));
  }

  /// `a(k)`, `b(k)`: bound k of the boxes in lanes.
  template <class A, class B>
  [[gnu::always_inline]] auto meet(const A& a, const B& b) const {
    const FloatLanes zero(0.0f), reach(near_.reach);
    const auto above = [&](int k) { return b(k) - a(kHigh + k); };
    const auto below = [&](int k) { return a(k) - b(kHigh + k); };
    FloatLanes gap2(0.0f), way2(0.0f), far2(0.0f), size(0.0f);
    for (int axis = 0; axis < 3; ++axis) {
      const auto way = max(-min(above(kDrift + axis), below(kDrift + axis)), zero), reached = reach * way;
      const auto apart = max(max(above(axis), below(axis)), zero), far = max(-min(above(axis), below(axis)), zero);
      gap2 = gap2 + apart * apart;
      way2 = way2 + reached * reached;
      far2 = far2 + far * far;
      size = max(size, far + way);
    }
    const auto kept = FloatLanes(near_.fraction) * sqrt(min(far2, way2)) + FloatLanes(kRoomOfBoxes) * size;
    return (gap2 <= way2) & (gap_in_halves(a, b) <= kept);
  }

  float t_limit() const { return near_.t_limit; }

 private:
  static constexpr int kDrift = 6, kHigh = 9;
  using Ends = EndBounds<kHigh>;
  /// At the end of the step the boxes are together larger by their way at most.
  static constexpr auto kRoomOfBoxes = static_cast<float>(error_bounds::kRoomOfBoxes);

  /// What is open in each half of the time until t_limit, on one side of an axis: as much as a clip in time sees, but
  /// for few pairs, in less time (docs/performance.md, "Step lengths").
  template <class A, class B>
  [[gnu::always_inline]] static FloatLanes gap_in_halves(const A& a, const B& b) {
    FloatLanes first(-kNowhere), second(-kNowhere);
    Ends::for_each_side(a, b, [&](const auto& at0, const auto& later) {
      const FloatLanes halfway = FloatLanes(0.5f) * (at0 + later);
      first = max(first, min(at0, halfway));
      second = max(second, min(halfway, later));
    });
    return min(first, second);
  }

  const NearRule near_;
};

}  // namespace tamis::TAMIS_ISA

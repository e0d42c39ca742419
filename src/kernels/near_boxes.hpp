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

  NearBoxes(const Search& search, int)
      : t_limit_(search.near.t_limit),
        reach2_(search.near.reach * search.near.reach),
        kept2_((1 + kShare) * search.near.fraction * search.near.fraction) {}

  void bound(const TreeView& tree, int level, int node, Bounds& bounds) const {
    Ends::store(tree.levels[level][node], t_limit_, bounds);
    const BoxBlock& drifts = tree.drifts[level][node];
    __builtin_memcpy(bounds.at[kDrift], drifts.low1, sizeof(drifts.low1));
    __builtin_memcpy(bounds.at[kHigh + kDrift], drifts.high1, sizeof(drifts.high1));
  }

  /// `a(k)`, `b(k)`: bound k of the boxes in lanes.
  template <class A, class B>
  [[gnu::always_inline]] auto meet(const A& a, const B& b) const {
    const FloatLanes zero(0.0f);
    FloatLanes gap2(0.0f), way2(0.0f), far2(0.0f), first2(0.0f), second2(0.0f);
    for (int axis = 0; axis < 3; ++axis) {
      const int drift = axis + kDrift;
      add_square(way2, max(max(b(kHigh + drift) - a(drift), a(kHigh + drift) - b(drift)), zero));
      FloatLanes gap(0.0f), far(0.0f), first(0.0f), second(0.0f);
      Ends::for_each_side(axis, a, b, [&](const auto& at0, const auto& later) {
        gap = max(gap, at0);
        far = min(far, at0);
        const FloatLanes least = min(at0, later);  // halfway is the mean of both
        first = max(first, at0 + least);
        second = max(second, least + later);
      });
      add_square(gap2, gap);
      add_square(far2, far);
      add_square(first2, first);
      add_square(second2, second);
    }
    const FloatLanes reached2 = FloatLanes(reach2_) * way2;
    const FloatLanes kept2 = FloatLanes(kept2_) * min(far2, reached2) + FloatLanes(kRoom2) * (far2 + way2);
    return (gap2 <= reached2) & (FloatLanes(0.25f) * min(first2, second2) <= kept2);
  }

  float t_limit() const { return t_limit_; }

 private:
  static constexpr int kDrift = 6, kHigh = 9;
  using Ends = EndBounds<kHigh>;
  /// (x + y)^2 is at most (1 + kShare) x^2 + (1 + 1 / kShare) y^2.
  static constexpr float kShare = 0x1p-4f;
  /// At the end of the step the boxes are together larger by their way at most: along an axis they extend over far +
  /// way, whose square is at most 2 (far^2 + way^2).
  static constexpr auto kRoom2 =
      static_cast<float>(2 * (1 + 1 / kShare) * error_bounds::kRoomOfBoxes * error_bounds::kRoomOfBoxes);

  [[gnu::always_inline]] static void add_square(FloatLanes& sum, const FloatLanes& x) { sum = sum + x * x; }

  const float t_limit_, reach2_, kept2_;
};

}  // namespace tamis::TAMIS_ISA

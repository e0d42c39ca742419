// Moving boxes and residuals: in which of them may a pair of features lose more of its distance than it may?
#pragma once
#include "kernels/box_overlap.hpp"

namespace tamis::TAMIS_ISA {

[[gnu::always_inline]] inline void add_square(FloatLanes& sum, const FloatLanes& x) { sum = sum + x * x; }

/// Of a pair, as ClearanceBounds has it: half of the square of its extent, and of what its clearance may be.
[[gnu::always_inline]] inline FloatLanes size2(const ClearanceBounds& bounds, const FloatLanes& way2,
                                               const FloatLanes& far2) {
  return FloatLanes(bounds.stretch2) * far2 + way2;
}
[[gnu::always_inline]] inline FloatLanes clearance2(const ClearanceBounds& bounds, const FloatLanes& way2,
                                                    const FloatLanes& size2) {
  return FloatLanes(bounds.per_way2) * way2 + FloatLanes(bounds.per_size2) * size2 + FloatLanes(bounds.fixed2);
}

/// Boxes that move, with the residuals of what they hold. A pair of features can, by search.near, end the step only
/// - if its clearance, and so the boxes' gap at t=0, is within ClearanceBounds; squares of lengths are compared: gaps
/// are
///   multiples of 2^-47, because boxes have margins, so that nothing that matters underflows;
/// - while the boxes are as near as the fraction of the largest clearance of such a pair, or of any pair between the
///   farthest corners. Boxes are wider by the minimum separation, which so is in all gaps.
class NearBoxes {
 public:
  static constexpr bool kMoves = false;
  using Bounds = BoundBlock<18>;  ///< x y z at t=0, at t_limit, of residuals; upper ends from kHigh on

  NearBoxes(const Search& search, int)
      : t_limit_(search.near.t_limit),
        clearance_(search.near.clearance),
        kept2_((1 + kShare) * search.near.fraction * search.near.fraction) {}

  void bound(const TreeView& tree, int level, int node, Bounds& bounds) const {
    const BoxBlock &block = tree.levels[level][node], &residuals = tree.residuals[level][node];
    const FloatLanes t(t_limit_), margin(kLaterMargin);
    for (int axis = 0; axis < 3; ++axis)
      for_sixteen_lanes([&](int first) {
        const auto load = [&](const float* lanes) { return FloatLanes::load_aligned(lanes + first); };
        const auto l0 = load(block.low0[axis]), l1 = load(block.low1[axis]);
        const auto h0 = load(block.high0[axis]), h1 = load(block.high1[axis]);
        l0.store_aligned(bounds.at[axis] + first);
        h0.store_aligned(bounds.at[kHigh + axis] + first);
        (t_limit_ < 1 ? l0 + t * (l1 - l0) - margin : l1).store_aligned(bounds.at[3 + axis] + first);
        (t_limit_ < 1 ? h0 + t * (h1 - h0) + margin : h1).store_aligned(bounds.at[kHigh + 3 + axis] + first);
      });
    __builtin_memcpy(bounds.at[kResidual], residuals.low1, sizeof(residuals.low1));
    __builtin_memcpy(bounds.at[kHigh + kResidual], residuals.high1, sizeof(residuals.high1));
  }

  /// `a(k)`, `b(k)`: bound k of the boxes in lanes.
  template <class A, class B>
  [[gnu::always_inline]] auto meet(const A& a, const B& b) const {
    const FloatLanes zero(0.0f);
    FloatLanes gap2(0.0f), way2(0.0f), far2(0.0f), first2(0.0f), second2(0.0f);
    for (int axis = 0; axis < 3; ++axis) {
      const int rest = axis + kResidual;
      add_square(way2, max(max(b(kHigh + rest) - a(rest), a(kHigh + rest) - b(rest)), zero));
      FloatLanes gap(0.0f), far(0.0f), first(0.0f), second(0.0f);
      for_each_side(axis, a, b, [&](const auto& at0, const auto& later) {
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
    const FloatLanes size = size2(clearance_, way2, far2), clearance = clearance2(clearance_, way2, size);
    const FloatLanes kept2 = FloatLanes(kept2_) * min(far2, clearance) + FloatLanes(kRoom2) * size;
    return (gap2 <= clearance) & (FloatLanes(0.25f) * min(first2, second2) <= kept2);
  }

  float t_limit() const { return t_limit_; }

 private:
  static constexpr int kResidual = 6, kHigh = 9;

  /// f(gap at t=0, gap later) for both sides of an axis: each is what two points that move linearly are apart.
  template <class A, class B, class F>
  [[gnu::always_inline]] static void for_each_side(int axis, const A& a, const B& b, const F& f) {
    f(b(axis) - a(kHigh + axis), b(3 + axis) - a(kHigh + 3 + axis));
    f(a(axis) - b(kHigh + axis), a(3 + axis) - b(kHigh + 3 + axis));
  }

  /// (x + y)^2 is at most (1 + kShare) x^2 + (1 + 1 / kShare) y^2.
  static constexpr float kShare = 0x1p-4f;
  static constexpr auto kRoom2 =
      static_cast<float>(2 * (1 + 1 / kShare) * error_bounds::kRoomOfBoxes * error_bounds::kRoomOfBoxes);

  const float t_limit_;
  const ClearanceBounds clearance_;
  const float kept2_;
};

/// The same by the clearance alone, where there is no gradient: less than half the work, and hardly more pairs where
/// features go a short way beside each other.
class ClearanceBoxes {
 public:
  static constexpr bool kMoves = false;
  using Bounds = BoundBlock<12>;  ///< x y z at t=0, of residuals

  ClearanceBoxes(const Search& search, int)
      : t_limit_(search.near.t_limit), per_way2_(search.near.clearance.per_way2) {}

  void bound(const TreeView& tree, int level, int node, Bounds& bounds) const {
    const BoxBlock &boxes = tree.levels[level][node], &residuals = tree.residuals[level][node];
    __builtin_memcpy(bounds.at, boxes.low0, sizeof(boxes.low0));
    __builtin_memcpy(bounds.at[kResidual], residuals.low1, sizeof(residuals.low1));
    __builtin_memcpy(bounds.at[kHigh], boxes.high0, sizeof(boxes.high0));
    __builtin_memcpy(bounds.at[kHigh + kResidual], residuals.high1, sizeof(residuals.high1));
  }

  template <class A, class B>
  [[gnu::always_inline]] auto meet(const A& a, const B& b) const {
    const FloatLanes zero(0.0f);
    FloatLanes gap2(0.0f), way2(0.0f);
    for (int axis = 0; axis < 3; ++axis) {
      const int rest = axis + kResidual;
      add_square(gap2, max(max(b(axis) - a(kHigh + axis), a(axis) - b(kHigh + axis)), zero));
      add_square(way2, max(max(b(kHigh + rest) - a(rest), a(kHigh + rest) - b(rest)), zero));
    }
    return gap2 <= FloatLanes(per_way2_) * way2;
  }

  float t_limit() const { return t_limit_; }

 private:
  static constexpr int kResidual = 3, kHigh = 6;

  const float t_limit_, per_way2_;
};

/// Is there no gradient, and do all features go less far beside each other than half of a leaf block's size? Then
/// where the boxes come near says little more than how near they are (docs/history/performance.md, "What chooses").
inline bool goes_a_short_way(const Search& search, int block) {
  if (search.near.clearance.per_size2 > 0) return false;
  const BoxBlock& hulls = search.a.levels[1][block / kBlock];
  const int lane = block % kBlock;
  float size = 0;
  for (int axis = 0; axis < 3; ++axis) size += hulls.high0[axis][lane] - hulls.low0[axis][lane];
  return search.near.reach * search.near.spread < 0.5f * size;
}

}  // namespace tamis::TAMIS_ISA

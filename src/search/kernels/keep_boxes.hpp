// Box test for step lengths. Finds the moving boxes in which features may come nearer than the fraction of their
// distance that they must keep.
#pragma once
#include <cstring>

#include "numbers/platform.hpp"
#include "search/kernels/reach.hpp"

namespace tamis::TAMIS_ISA {

/// size^2 of ClearanceBounds for two boxes, and the bound of clearance^2.
TAMIS_ALWAYS_INLINE FloatLanes size2(const ClearanceBounds& bounds, const FloatLanes& residual2,
                                     const FloatLanes& farthest2) {
  return FloatLanes(bounds.stretch2) * farthest2 + residual2;
}
TAMIS_ALWAYS_INLINE FloatLanes clearance2(const ClearanceBounds& bounds, const FloatLanes& residual2,
                                          const FloatLanes& size2) {
  return FloatLanes(bounds.per_residual2) * residual2 + FloatLanes(bounds.per_size2) * size2 +
         FloatLanes(bounds.fixed2);
}

/// Boxes that move, with the residuals of their features. By search.keep, a pair of features can end the step only
/// - if its clearance, and thus the boxes' gap at t=0, is within ClearanceBounds. Squares of lengths are compared, and
///   do not underflow where it matters: gaps are multiples of 2^-47, because boxes have margins;
/// - while the boxes are no farther apart than the fraction of the largest clearance at t=0 that the pair can have, by
///   ClearanceBounds and by the distance of the boxes' farthest corners.
/// Boxes are widened by the minimum separation, so all gaps are shorter by it.
class KeepBoxes {
 public:
  static constexpr bool kMoves = false, kHasReach = true;
  using Bounds = BoundBlock<18>;  ///< x y z at t=0, at t_limit, of residuals; upper ends from kHigh on

  KeepBoxes(const Search& search, int)
      : t_limit_(search.keep.t_limit),
        has_outliers_(search.has_outliers),
        clearance_(search.keep.clearance),
        kept2_((1 + kShare) * search.keep.fraction * search.keep.fraction) {}

  void bound(const TreeView& tree, int level, int node, Bounds& bounds) const {
    const BoxBlock &block = tree.levels[level][node], &residuals = tree.residuals[level][node];
    const FloatLanes t(t_limit_);
    for (int axis = 0; axis < 3; ++axis)
      for_sixteen_lanes([&](int first) {
        const auto l0 = lanes_of(block.low0[axis], first), l1 = lanes_of(block.low1[axis], first);
        const auto h0 = lanes_of(block.high0[axis], first), h1 = lanes_of(block.high1[axis], first);
        FloatLanes margin(kLaterMargin);
        if (has_outliers_) margin = margin + later_outlier_margin(block, axis, first);
        l0.store_aligned(bounds.at[axis] + first);
        h0.store_aligned(bounds.at[kHigh + axis] + first);
        (t_limit_ < 1 ? l0 + t * (l1 - l0) - margin : l1).store_aligned(bounds.at[3 + axis] + first);
        (t_limit_ < 1 ? h0 + t * (h1 - h0) + margin : h1).store_aligned(bounds.at[kHigh + 3 + axis] + first);
      });
    std::memcpy(bounds.at[kResidual], residuals.low1, sizeof(residuals.low1));
    std::memcpy(bounds.at[kHigh + kResidual], residuals.high1, sizeof(residuals.high1));
  }

  /// `a(k)`, `b(k)`: bound k of the boxes in lanes.
  template <class A, class B>
  TAMIS_ALWAYS_INLINE auto meet(const A& a, const B& b) const {
    const FloatLanes residual2 = greatest_residual2<kResidual, kHigh>(a, b);
    FloatLanes gap2(0.0f), farthest2(0.0f), first2(0.0f), second2(0.0f);
    for (int axis = 0; axis < 3; ++axis) {
      FloatLanes gap(0.0f), far(0.0f), first(0.0f), second(0.0f);
      for_each_side(axis, a, b, [&](const auto& at0, const auto& later) {
        gap = max(gap, at0);
        far = min(far, at0);
        // Halfway the gap is the mean of both. Each sum below is twice the least gap of one half of the time.
        const FloatLanes least = min(at0, later);
        first = max(first, at0 + least);
        second = max(second, least + later);
      });
      add_square(gap2, gap);
      add_square(farthest2, far);
      add_square(first2, first);
      add_square(second2, second);
    }
    const FloatLanes size = size2(clearance_, residual2, farthest2),
                     clearance = clearance2(clearance_, residual2, size);
    const FloatLanes kept2 = FloatLanes(kept2_) * min(farthest2, clearance) + FloatLanes(kClearance2) * size;
    return (gap2 <= clearance) & (FloatLanes(0.25f) * min(first2, second2) <= kept2);
  }

  /// How far apart along each axis features in the boxes can be at t=0 and still end the step.
  template <class A, class B>
  TAMIS_ALWAYS_INLINE FloatLanes reach(const A& a, const B& b) const {
    const FloatLanes residual2 = greatest_residual2<kResidual, kHigh>(a, b);
    FloatLanes farthest2(0.0f);
    for (int axis = 0; axis < 3; ++axis)
      add_square(farthest2, min(min(b(axis) - a(kHigh + axis), a(axis) - b(kHigh + axis)), FloatLanes(0.0f)));
    return reach_of(clearance2(clearance_, residual2, size2(clearance_, residual2, farthest2)));
  }

  float t_limit() const { return t_limit_; }

 private:
  static constexpr int kResidual = 6, kHigh = 9;

  /// Calls f(gap at t=0, gap at t_limit) for both sides of an axis. A gap is the difference of two points that move
  /// linearly.
  template <class A, class B, class F>
  TAMIS_ALWAYS_INLINE static void for_each_side(int axis, const A& a, const B& b, const F& f) {
    f(b(axis) - a(kHigh + axis), b(3 + axis) - a(kHigh + 3 + axis));
    f(a(axis) - b(kHigh + axis), a(3 + axis) - b(kHigh + 3 + axis));
  }

  /// (x + y)^2 <= (1 + kShare) x^2 + (1 + 1 / kShare) y^2.
  static constexpr float kShare = 0x1p-4f;
  static constexpr auto kClearance2 = static_cast<float>(2 * (1 + 1 / kShare) * error_bounds::kBoxAdvanceClearance *
                                                         error_bounds::kBoxAdvanceClearance);

  const float t_limit_;
  const bool has_outliers_;
  const ClearanceBounds clearance_;
  const float kept2_;
};

}  // namespace tamis::TAMIS_ISA

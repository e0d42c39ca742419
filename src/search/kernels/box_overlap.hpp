// Box tests of the search: whether moving boxes meet, swept or at one time, and whether boxes at rest are within the
// separation.
#pragma once
#include <algorithm>
#include <cstring>

#include "numbers/lanes.hpp"
#include "numbers/platform.hpp"
#include "pair/motion/time_clip.hpp"
#include "search/bounds/moving_boxes.hpp"
#include "search/kernels/kernels.hpp"
#include "search/kernels/sixteen_lanes.hpp"

namespace tamis::TAMIS_ISA {

/// `count` numbers of each of sixteen boxes, [number][lane]: first the lower ends, then as many upper ends.
template <int count>
struct alignas(64) BoundBlock {
  static constexpr int kCount = count;
  float at[count][kBlock];

  FloatLanes lanes(int k, int first) const { return lanes_of(at[k], first); }
};

/// Interpolated boxes, and boxes relative to a moving observer, are off by less than this
/// (docs/numerics/one-pair.md, "Boxes").
inline constexpr float kLaterMargin = 0x1p-18f;
/// Boxes of outliers are off by less than this besides, times their largest coordinate along the axis. The difference
/// of the coordinates at both ends is off by 2^-23 of that. Its product with a time is off by as much, and carries the
/// difference's error. Subtracting the observer's displacement is off by 2^-23, the sum by 2^-24.
inline constexpr float kLaterOutlierMargin = 0x1p-20f;

/// The margin that kLaterOutlierMargin gives each box of a block along an axis.
inline FloatLanes later_outlier_margin(const BoxBlock& block, int axis, int first) {
  const auto larger = [&](const float(&low)[3][kBlock], const float(&high)[3][kBlock]) {
    return max(-lanes_of(low[axis], first), lanes_of(high[axis], first));
  };
  return FloatLanes(kLaterOutlierMargin) * max(larger(block.low0, block.high0), larger(block.low1, block.high1));
}

/// The gap of two boxes along an axis: 0 or less if they meet there. `a(k)`, `b(k)`: bound k of the boxes in lanes, the
/// upper end along the axis at `high` + axis.
template <class A, class B>
TAMIS_ALWAYS_INLINE FloatLanes gap_along(int axis, int high, const A& a, const B& b) {
  return max(b(axis) - a(high + axis), a(axis) - b(high + axis));
}

/// The largest gap of two boxes along x, y and z, of bounds as above, upper ends from 3 on.
template <class A, class B>
TAMIS_ALWAYS_INLINE FloatLanes largest_gap(const A& a, const B& b) {
  FloatLanes gap = gap_along(0, 3, a, b);  // cheaper than six masks
  for (int axis = 1; axis < 3; ++axis) gap = max(gap, gap_along(axis, 3, a, b));
  return gap;
}

/// The extents of boxes at t=0, summed over the axes.
inline FloatLanes extent_at_start(const BoxBlock& block, int first) {
  FloatLanes sum(0.0f);
  for (int axis = 0; axis < 3; ++axis)
    sum = sum + (lanes_of(block.high0[axis], first) - lanes_of(block.low0[axis], first));
  return sum;
}

/// Boxes that move until t_limit. The cheap test (meet) compares swept boxes, relative to an observer who moves with
/// the leaf block searched from. So a common motion makes no box larger. The sharp test (meet_at_some_time) looks for a
/// time at which all gaps between two boxes are closed. Two features can touch only if their boxes pass both tests.
class MovingBoxes {
 public:
  static constexpr bool kMoves = true, kHasReach = false;
  using Bounds = BoundBlock<6>;  ///< of the swept boxes: x y z

  /// For a search from leaf block `block` of search.a.
  MovingBoxes(const Search& search, int block) : t_limit_(search.t_limit), has_outliers_(search.has_outliers) {
    constexpr float kMostDisplacement = 4;  // only outliers go farther; no observer follows them
    const BoxBlock& hulls = search.a.levels[1][block / kBlock];
    const int lane = block % kBlock;
    for (int axis = 0; axis < 3; ++axis) {
      const float twice =
          (hulls.low1[axis][lane] - hulls.low0[axis][lane]) + (hulls.high1[axis][lane] - hulls.high0[axis][lane]);
      observer_displacement_[axis] = 0.5f * t_limit_ * std::clamp(twice, -2 * kMostDisplacement, 2 * kMostDisplacement);
    }
  }

  void bound(const TreeView& tree, int level, int node, Bounds& bounds) const {
    const BoxBlock& block = tree.levels[level][node];
    const FloatLanes t(t_limit_);
    if (t_limit_ == 1)
      sweep(block, bounds, [](const auto&, const auto& at1, const auto& observer) { return at1 - observer; });
    else
      sweep(block, bounds,
            [&](const auto& at0, const auto& at1, const auto& observer) { return at0 + (t * (at1 - at0) - observer); });
    if (has_outliers_) widen(block, bounds);
  }

  /// The cheap test: whether the swept boxes meet. Their bounds are off by less than kLaterMargin each.
  template <class A, class B>
  TAMIS_ALWAYS_INLINE auto meet(const A& a, const B& b) const {
    return largest_gap(a, b) <= FloatLanes(2 * kLaterMargin);
  }

  /// Means over a leaf block's boxes of the extent at t=0, summed over the axes, and of its growth by sweeping.
  struct Means {
    float size = 0, growth = 0;
  };
  Means means(const BoxBlock& block, const Bounds& swept) const {
    float sizes[kBlock], growths[kBlock], used = 0;
    for_sixteen_lanes([&](int first) {
      const FloatLanes size = extent_at_start(block, first);
      size.store_unaligned(sizes + first);
      (swept_extent(swept, first) - size).store_unaligned(growths + first);
    });
    Means sum;
    for (int lane = 0; lane < kBlock; ++lane) {
      const bool is_used = sizes[lane] >= 0;
      sum.size += is_used ? sizes[lane] : 0;
      sum.growth += is_used ? growths[lane] : 0;
      used += is_used ? 1 : 0;
    }
    return {sum.size / used, sum.growth / used};
  }

  /// Bits of a node's children whose features, judged by the hulls, move far for their size and for the size of mine.
  unsigned move_far(const BoxBlock& block, const Bounds& swept, const Means& mine) const {
    return bits_of_sixteen([&](int first) {
      const FloatLanes size = extent_at_start(block, first);
      const FloatLanes growth = swept_extent(swept, first) - size + FloatLanes(mine.growth);
      return growth > FloatLanes(kShort) * (FloatLanes(mine.size) + FloatLanes(0.25f) * size);
    });
  }

  /// Bits of the sixteen boxes that meet one box at some time: the sharp test.
  unsigned meet_at_some_time(const BoxBlock& one, int lane, const BoxBlock& sixteen) const {
    return bits_of_sixteen([&](int first) {
      TimeClip<FloatLanes> clip({FloatLanes(0.0f), FloatLanes(t_limit_)});
      for (int axis = 0; axis < 3; ++axis) {
        clip.cut_positive(lanes_of(sixteen.low0[axis], first) - FloatLanes(one.high0[axis][lane]),
                          lanes_of(sixteen.low1[axis], first) - FloatLanes(one.high1[axis][lane]));
        clip.cut_positive(FloatLanes(one.low0[axis][lane]) - lanes_of(sixteen.high0[axis], first),
                          FloatLanes(one.low1[axis][lane]) - lanes_of(sixteen.high1[axis], first));
      }
      const auto time = clip.rest();
      return time.t_in <= time.t_out;
    });
  }

  float t_limit() const { return t_limit_; }

 private:
  /// Bounds the swept boxes. `at_limit(at0, at1, the observer's displacement)`: where an end of the boxes is at
  /// t_limit, relative to the observer.
  template <class F>
  TAMIS_ALWAYS_INLINE void sweep(const BoxBlock& block, Bounds& bounds, const F& at_limit) const {
    for (int axis = 0; axis < 3; ++axis)
      for_sixteen_lanes([&](int first) {
        const FloatLanes observer(observer_displacement_[axis]);
        const FloatLanes low = lanes_of(block.low0[axis], first), high = lanes_of(block.high0[axis], first);
        min(at_limit(low, lanes_of(block.low1[axis], first), observer), low).store_aligned(bounds.at[axis] + first);
        max(at_limit(high, lanes_of(block.high1[axis], first), observer), high)
            .store_aligned(bounds.at[3 + axis] + first);
      });
  }

  /// Widens the bounds by the error of outliers' bounds.
  static void widen(const BoxBlock& block, Bounds& bounds) {
    for (int axis = 0; axis < 3; ++axis)
      for_sixteen_lanes([&](int first) {
        const FloatLanes margin = later_outlier_margin(block, axis, first);
        (bounds.lanes(axis, first) - margin).store_aligned(bounds.at[axis] + first);
        (bounds.lanes(3 + axis, first) + margin).store_aligned(bounds.at[3 + axis] + first);
      });
  }

  static FloatLanes swept_extent(const Bounds& swept, int first) {
    FloatLanes sum(0.0f);
    for (int axis = 0; axis < 3; ++axis) sum = sum + (swept.lanes(3 + axis, first) - swept.lanes(axis, first));
    return sum;
  }

  /// If boxes grow by no more than this part of their extent in sweeping, the cheap test is as sharp as the sharp one.
  /// Chosen on kick, armadillo-rollers and cloth-ball at several scales.
  static constexpr float kShort = 0.3f;
  const float t_limit_;
  const bool has_outliers_;
  float observer_displacement_[3] = {};  ///< until t_limit
};

/// Boxes at t=0, widened by the separation. Two features can be within the separation only if their unwidened boxes
/// are. The distance of these is the root of the sum of the squares of the three gaps.
class RestBoxes {
 public:
  static constexpr bool kMoves = false, kHasReach = false;
  using Bounds = BoundBlock<6>;  ///< x y z

  RestBoxes(const Search& search, int)
      : widened_(search.widened), widened2_(search.widened * search.widened * (1 + 0x1p-20f)) {}

  void bound(const TreeView& tree, int level, int node, Bounds& bounds) const {
    const BoxBlock& block = tree.levels[level][node];
    std::memcpy(bounds.at, block.low0, sizeof(block.low0));
    std::memcpy(bounds.at[3], block.high0, sizeof(block.high0));
  }

  /// `a(k)`, `b(k)`: bound k of the boxes in lanes.
  template <class A, class B>
  TAMIS_ALWAYS_INLINE auto meet(const A& a, const B& b) const {
    const FloatLanes zero(0.0f), widened(widened_);
    FloatLanes gap2(0.0f);
    for (int axis = 0; axis < 3; ++axis) {
      const auto gap = max(gap_along(axis, 3, a, b) + widened, zero);
      gap2 = gap2 + gap * gap;
    }
    return gap2 <= FloatLanes(widened2_);
  }

  float t_limit() const { return 1; }

 private:
  const float widened_, widened2_;
};

}  // namespace tamis::TAMIS_ISA

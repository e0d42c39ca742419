// Boxes as the search sees them, and which of them may meet: by what they sweep over, by where they are at both ends of
// the step, or at rest.
#pragma once
#include "bounds/moving_boxes.hpp"
#include "kernels/kernels.hpp"
#include "kernels/sixteen_lanes.hpp"
#include "motion/time_clip.hpp"
#include "numerics/lanes.hpp"

namespace tamis::TAMIS_ISA {

/// `count` numbers of each of sixteen boxes, [number][lane]: first the lower ends, then as many upper ends.
template <int count>
struct alignas(64) BoundBlock {
  static constexpr int kCount = count;
  float at[count][kBlock];

  FloatLanes lanes(int k, int first) const { return FloatLanes::load_aligned(at[k] + first); }
};

/// Boxes between the ends of the step, and boxes seen by an observer who moves, are off by less than this
/// (docs/numerics.md, "Boxes").
inline constexpr float kLaterMargin = 0x1p-18f;

/// Of boxes along three axes, x y z: 0 or less if two meet. `a(k)`, `b(k)`: bound k of the boxes in lanes.
template <class A, class B>
[[gnu::always_inline]] inline FloatLanes largest_gap(const A& a, const B& b) {
  FloatLanes gap = max(b(0) - a(3), a(0) - b(3));  // cheaper than six masks
  for (int axis = 1; axis < 3; ++axis) gap = max(gap, max(b(axis) - a(3 + axis), a(axis) - b(3 + axis)));
  return gap;
}

/// Of boxes at t=0, as a sum over the axes.
inline FloatLanes extent_at_start(const BoxBlock& block, int first) {
  FloatLanes sum(0.0f);
  for (int axis = 0; axis < 3; ++axis)
    sum = sum +
          (FloatLanes::load_aligned(block.high0[axis] + first) - FloatLanes::load_aligned(block.low0[axis] + first));
  return sum;
}

/// Boxes that move until t_limit. A cheap test looks at what they sweep over, for an observer who moves as the block
/// does from which the search starts: a motion common to all makes no box larger. A sharp one looks for a time at which
/// all gaps between two boxes are closed. Two features can meet only where their boxes do.
class MovingBoxes {
 public:
  static constexpr bool kMoves = true, kHasReach = false;
  using Bounds = BoundBlock<6>;  ///< what boxes sweep over: x y z

  /// From leaf block `block` of search.a.
  MovingBoxes(const Search& search, int block) : t_limit_(search.t_limit) {
    const BoxBlock& hulls = search.a.levels[1][block / kBlock];
    const int lane = block % kBlock;
    for (int axis = 0; axis < 3; ++axis)
      way_[axis] =
          0.5f * t_limit_ *
          ((hulls.low1[axis][lane] - hulls.low0[axis][lane]) + (hulls.high1[axis][lane] - hulls.high0[axis][lane]));
  }

  void bound(const TreeView& tree, int level, int node, Bounds& bounds) const {
    const BoxBlock& block = tree.levels[level][node];
    const FloatLanes t(t_limit_);
    if (t_limit_ == 1)
      sweep(block, bounds, [](const auto&, const auto& at1, const auto& way) { return at1 - way; });
    else
      sweep(block, bounds,
            [&](const auto& at0, const auto& at1, const auto& way) { return at0 + (t * (at1 - at0) - way); });
  }

  /// Bounds are off by less than kLaterMargin each.
  template <class A, class B>
  [[gnu::always_inline]] auto meet(const A& a, const B& b) const {
    return largest_gap(a, b) <= FloatLanes(2 * kLaterMargin);
  }

  /// What the boxes of a leaf block are like, in the mean, as sums over the axes: how large, and how much larger by
  /// being swept.
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

  /// Bits of the leaf blocks of a node, by their hulls, whose features move far, for their size and that of mine.
  unsigned move_far(const BoxBlock& block, const Bounds& swept, const Means& mine) const {
    unsigned mask = 0;
    for_sixteen_lanes([&](int first) {
      const FloatLanes size = extent_at_start(block, first);
      const FloatLanes growth = swept_extent(swept, first) - size + FloatLanes(mine.growth);
      mask |= bits(growth > FloatLanes(kShort) * (FloatLanes(mine.size) + FloatLanes(0.25f) * size)) << first;
    });
    return mask;
  }

  /// Bits of the sixteen that meet one box at some time.
  unsigned meet_at_some_time(const BoxBlock& one, int lane, const BoxBlock& sixteen) const {
    unsigned mask = 0;
    for_sixteen_lanes([&](int first) {
      const auto load = [&](const float* lanes) { return FloatLanes::load_aligned(lanes + first); };
      TimeClip<FloatLanes> clip({FloatLanes(0.0f), FloatLanes(t_limit_)});
      for (int axis = 0; axis < 3; ++axis) {
        clip.cut_positive(load(sixteen.low0[axis]) - FloatLanes(one.high0[axis][lane]),
                          load(sixteen.low1[axis]) - FloatLanes(one.high1[axis][lane]));
        clip.cut_positive(FloatLanes(one.low0[axis][lane]) - load(sixteen.high0[axis]),
                          FloatLanes(one.low1[axis][lane]) - load(sixteen.high1[axis]));
      }
      const auto time = clip.rest();
      mask |= bits(time.t_in <= time.t_out) << first;
    });
    return mask;
  }

  float t_limit() const { return t_limit_; }

 private:
  /// `at_limit(at0, at1, way)`: an end of boxes at t_limit, as the observer sees it.
  template <class F>
  [[gnu::always_inline]] void sweep(const BoxBlock& block, Bounds& bounds, const F& at_limit) const {
    for (int axis = 0; axis < 3; ++axis)
      for_sixteen_lanes([&](int first) {
        const auto load = [&](const float* lanes) { return FloatLanes::load_aligned(lanes + first); };
        const FloatLanes way(way_[axis]), low0 = load(block.low0[axis]), high0 = load(block.high0[axis]);
        min(at_limit(low0, load(block.low1[axis]), way), low0).store_aligned(bounds.at[axis] + first);
        max(at_limit(high0, load(block.high1[axis]), way), high0).store_aligned(bounds.at[3 + axis] + first);
      });
  }

  static FloatLanes swept_extent(const Bounds& swept, int first) {
    FloatLanes sum(0.0f);
    for (int axis = 0; axis < 3; ++axis) sum = sum + (swept.lanes(3 + axis, first) - swept.lanes(axis, first));
    return sum;
  }

  /// Growth of a box by what it sweeps over, for its size, up to which the cheap test is as sharp
  /// (docs/history/performance.md, "What chooses").
  static constexpr float kShort = 0.3f;
  const float t_limit_;
  float way_[3] = {};  ///< the observer's until t_limit
};

/// Boxes at t=0: two features are near only where their boxes, without what these are widened by, are no farther apart
/// than that: by the root of the sum of the squares of the gaps on three axes.
class RestBoxes {
 public:
  static constexpr bool kMoves = false, kHasReach = false;
  using Bounds = BoundBlock<6>;  ///< x y z

  RestBoxes(const Search& search, int)
      : widened_(search.widened), widened2_(search.widened * search.widened * (1 + 0x1p-20f)) {}

  void bound(const TreeView& tree, int level, int node, Bounds& bounds) const {
    const BoxBlock& block = tree.levels[level][node];
    __builtin_memcpy(bounds.at, block.low0, sizeof(block.low0));
    __builtin_memcpy(bounds.at[3], block.high0, sizeof(block.high0));
  }

  /// `a(k)`, `b(k)`: bound k of the boxes in lanes.
  template <class A, class B>
  [[gnu::always_inline]] auto meet(const A& a, const B& b) const {
    const FloatLanes zero(0.0f), widened(widened_);
    FloatLanes gap2(0.0f);
    for (int axis = 0; axis < 3; ++axis) {
      const auto gap = max(max(b(axis) - a(3 + axis), a(axis) - b(3 + axis)) + widened, zero);
      gap2 = gap2 + gap * gap;
    }
    return gap2 <= FloatLanes(widened2_);
  }

  float t_limit() const { return 1; }

 private:
  const float widened_, widened2_;
};

}  // namespace tamis::TAMIS_ISA

// Boxes as the search sees them, and which of them may meet: by what they sweep over, by where they are at both ends of
// the step, or at rest.
#pragma once
#include "bounds/moving_boxes.hpp"
#include "kernels/kernels.hpp"
#include "numerics/lanes.hpp"

namespace tamis::TAMIS_ISA {

/// Calls f(first) for the batches that make up sixteen lanes.
template <class F>
[[gnu::always_inline]] inline void for_sixteen_lanes(const F& f) {
  for (int first = 0; first < kBlock; first += kFloatLanes) f(first);
}

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

/// Boxes at t=0.
class StillBoxes {
 public:
  using Bounds = BoundBlock<6>;  ///< x y z

  StillBoxes(const Search&, int) {}

  void bound(const TreeView& tree, int level, int node, Bounds& bounds) const {
    const BoxBlock& block = tree.levels[level][node];
    __builtin_memcpy(bounds.at, block.low0, sizeof(block.low0));
    __builtin_memcpy(bounds.at[3], block.high0, sizeof(block.high0));
  }

  template <class A, class B>
  [[gnu::always_inline]] auto meet(const A& a, const B& b) const {
    return largest_gap(a, b) <= FloatLanes(0.0f);
  }

  float t_limit() const { return 1; }
};

/// What boxes sweep over until t_limit, for an observer who moves as the block does from which the search starts: a
/// motion common to all makes no box larger. Two features can meet only where their boxes do.
class SweptBoxes {
 public:
  using Bounds = BoundBlock<6>;  ///< x y z

  /// From leaf block `block` of search.a.
  SweptBoxes(const Search& search, int block) : t_limit_(search.t_limit) {
    const BoxBlock& hulls = search.a.levels[1][block / kBlock];
    const int lane = block % kBlock;
    for (int axis = 0; axis < 3; ++axis)
      way_[axis] =
          0.5f * t_limit_ *
          ((hulls.low1[axis][lane] - hulls.low0[axis][lane]) + (hulls.high1[axis][lane] - hulls.high0[axis][lane]));
  }

  void bound(const TreeView& tree, int level, int node, Bounds& bounds) const {
    const BoxBlock& block = tree.levels[level][node];
    const FloatLanes t(t_limit_), margin(kLaterMargin);
    for (int axis = 0; axis < 3; ++axis)
      for (int first = 0; first < kBlock; first += kFloatLanes) {
        const auto load = [&](const float* lanes) { return FloatLanes::load_aligned(lanes + first); };
        const FloatLanes way(way_[axis]), l0 = load(block.low0[axis]), h0 = load(block.high0[axis]);
        const auto l = l0 + (t * (load(block.low1[axis]) - l0) - way);
        const auto h = h0 + (t * (load(block.high1[axis]) - h0) - way);
        (min(l, l0) - margin).store_aligned(bounds.at[axis] + first);
        (max(h, h0) + margin).store_aligned(bounds.at[3 + axis] + first);
      }
  }

  template <class A, class B>
  [[gnu::always_inline]] auto meet(const A& a, const B& b) const {
    return largest_gap(a, b) <= FloatLanes(0.0f);
  }

  float t_limit() const { return t_limit_; }

 private:
  const float t_limit_;
  float way_[3] = {};  ///< the observer's until t_limit
};

/// Boxes at rest: two features are near only where their boxes, without what these are widened by, are no farther apart
/// than that: by the root of the sum of the squares of the gaps on three axes.
class RestBoxes : public StillBoxes {
 public:
  RestBoxes(const Search& search, int block)
      : StillBoxes(search, block),
        widened_(search.widened),
        widened2_(search.widened * search.widened * (1 + 0x1p-20f)) {}

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

  float t_limit() const { return 0; }

 private:
  const float widened_, widened2_;
};

/// Bounds of boxes that move linearly, x y z at t=0, then at a later time: their lower ends from 0 on, their upper ends
/// from `kHigh` on.
template <int kHigh>
struct EndBounds {
  template <class Bounds>
  static void store(const BoxBlock& block, float later, Bounds& bounds) {
    const FloatLanes t(later), margin(kLaterMargin);
    for (int axis = 0; axis < 3; ++axis)
      for_sixteen_lanes([&](int first) {
        const auto load = [&](const float* lanes) { return FloatLanes::load_aligned(lanes + first); };
        const auto l0 = load(block.low0[axis]), l1 = load(block.low1[axis]);
        const auto h0 = load(block.high0[axis]), h1 = load(block.high1[axis]);
        l0.store_aligned(bounds.at[axis] + first);
        h0.store_aligned(bounds.at[kHigh + axis] + first);
        (later < 1 ? l0 + t * (l1 - l0) - margin : l1).store_aligned(bounds.at[3 + axis] + first);
        (later < 1 ? h0 + t * (h1 - h0) + margin : h1).store_aligned(bounds.at[kHigh + 3 + axis] + first);
      });
  }

  /// f(gap at t=0, gap later) of two boxes for both sides of an axis. `a(k)`, `b(k)`: bound k of the boxes in lanes.
  /// Each is what two points that move linearly are apart.
  template <class A, class B, class F>
  [[gnu::always_inline]] static void for_each_side(int axis, const A& a, const B& b, const F& f) {
    f(b(axis) - a(kHigh + axis), b(3 + axis) - a(kHigh + 3 + axis));
    f(a(axis) - b(kHigh + axis), a(3 + axis) - b(kHigh + 3 + axis));
  }
};

/// Boxes at t=0 and at t_limit. Where the gap between two is open on one side of an axis at both, it is open all the
/// time between: sharper than what they sweep over, and twice as much work.
class BoxesAtEnds {
 public:
  using Bounds = BoundBlock<12>;  ///< x y z at t=0, then at t_limit

  BoxesAtEnds(const Search& search, int) : t_limit_(search.t_limit) {}

  void bound(const TreeView& tree, int level, int node, Bounds& bounds) const {
    Ends::store(tree.levels[level][node], t_limit_, bounds);
  }

  template <class A, class B>
  [[gnu::always_inline]] auto meet(const A& a, const B& b) const {
    FloatLanes gap(-kNowhere);
    for (int axis = 0; axis < 3; ++axis)
      Ends::for_each_side(axis, a, b, [&](const auto& at0, const auto& later) { gap = max(gap, min(at0, later)); });
    return gap <= FloatLanes(0.0f);
  }

  float t_limit() const { return t_limit_; }

 private:
  using Ends = EndBounds<6>;

  const float t_limit_;
};

}  // namespace tamis::TAMIS_ISA

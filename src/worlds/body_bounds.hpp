// The boxes of a body's hierarchy in the frame of the world, during a piece of the step.
#pragma once
#include <deque>
#include <memory>
#include <vector>

#include "pair/motion/time_clip.hpp"
#include "search/bounds/box.hpp"
#include "worlds/body.hpp"

namespace tamis {

/// Bounds that move linearly, in the frame of the world. Each box is widened by kRounding of its coordinates. This
/// covers the rounding of may_meet().
struct MovingBounds {
  Box start, end;

  static constexpr double kRounding = 0x1p-44;

  Box hull() const {
    Box hull = start;
    hull.include(end);
    return hull;
  }
};

/// True if the bounds may come within `separation` at some time. False only if proven: at every time there is a gap
/// along some axis. NaN proves nothing.
inline bool may_meet(const MovingBounds& a, const MovingBounds& b, double separation) {
  TimeClip<double> clip({0, 1});
  constexpr double kPart = 0.125;  // of each gap, so no difference overflows
  const auto gap = [&](double low, double high) { return kPart * low - kPart * high - kPart * separation; };
  const auto are_apart = [&](const MovingBounds& below, const MovingBounds& above, std::size_t k) {
    const double g0 = gap(above.start.low[k], below.start.high[k]), g1 = gap(above.end.low[k], below.end.high[k]);
    if ((g0 > 0) != (g1 > 0)) clip.cut_positive(g0, g1);
    return g0 > 0 && g1 > 0;
  };
  for (std::size_t k = 0; k < 3; ++k)
    if (are_apart(a, b, k) || are_apart(b, a, k)) return false;
  const auto [t_in, t_out] = clip.rest();
  return !(t_in > t_out);
}

/// The bounds of one leaf's items.
struct ItemBounds {
  MovingBounds all;
  std::array<MovingBounds, kBlock> of_item;  ///< in the order of the tree
};

/// A body during one piece of the step.
class BodyOnPiece {
 public:
  /// Keeps a reference to the body. REQUIRES: 0 <= from <= to <= 1.
  BodyOnPiece(const Body& body, double from, double to);

  const BodyShape& shape() const { return body_.shape(); }
  MovingBounds bounds(Index node) const;
  /// The items of a leaf, bounded by their vertices: tighter than the leaf's box.
  ItemBounds items(Index leaf) const;

 private:
  MovingBounds cut(const Box& at_start, const Box& at_end) const;

  const Body& body_;
  const double from_, to_;
  double deviation_ = 0;              ///< a bound of the distance of its vertices from their chords
  RoundedTransform at_from_, at_to_;  ///< of a body that does not turn, at t=0 and t=1
};

/// Caches a body's bounds on a piece. Each is computed when it is first requested. References to them stay valid.
class BoundsOnPiece {
 public:
  BoundsOnPiece(const Body& body, double from, double to);

  const BodyShape& shape() const { return body_.shape(); }
  const MovingBounds& bounds(Index node);
  const ItemBounds& items(Index leaf);

 private:
  const BodyOnPiece body_;
  std::vector<const MovingBounds*> bounds_;               ///< of each node; null until requested
  std::vector<std::unique_ptr<const ItemBounds>> items_;  ///< of each leaf
  std::deque<MovingBounds> made_;                         ///< which bounds_ point to
};

}  // namespace tamis

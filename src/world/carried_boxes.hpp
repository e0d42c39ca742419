// The boxes of a body's hierarchy during a piece of the step, in the frame of the world.
#pragma once
#include <deque>

#include "bounds/box.hpp"
#include "world/pieces.hpp"

namespace tamis {

/// Of something in the world that goes straight from `start` to `end`. Each is wider than what it holds by kRounding of
/// its size: that is for the rounding of `may_meet`.
struct MovingBounds {
  Box start, end;

  static constexpr double kRounding = 0x1p-44;

  Box hull() const {
    Box hull = start;
    hull.include(end);
    return hull;
  }
};

/// Do they come within `separation` at one time? False only if proven: the gap along one axis is open, or those along
/// several are at times between them. What is not a number proves nothing.
inline bool may_meet(const MovingBounds& a, const MovingBounds& b, double separation) {
  constexpr double kRoundingOfTimes = 0x1p-40;
  double from = 0, to = 1;
  const auto close = [&](double gap0, double gap1) {
    if (!(gap0 > 0 || gap1 > 0)) return true;
    if (gap0 > 0 && gap1 > 0) return false;
    // Where a difference overflows these are 0 and 1, which prove nothing.
    if (gap0 > 0) from = std::max(from, gap0 / (gap0 - gap1));
    if (gap1 > 0) to = std::min(to, 1 - gap1 / (gap1 - gap0));
    return true;
  };
  for (std::size_t k = 0; k < 3; ++k) {
    if (!close(a.start.low[k] - b.start.high[k] - separation, a.end.low[k] - b.end.high[k] - separation)) return false;
    if (!close(b.start.low[k] - a.start.high[k] - separation, b.end.low[k] - a.end.high[k] - separation)) return false;
  }
  return !(from > to + kRoundingOfTimes);
}

/// The items of one block of items.
struct CarriedItems {
  MovingBounds all;
  std::array<MovingBounds, kBlock> of_item;  ///< in the order of the block
};

/// How far a point is at most from its chord on a piece, by its acceleration and wherever it goes: both bounds hold.
struct ChordBounds {
  double by_acceleration = 0, by_reach = 0;
};

/// A body during one piece.
class CarriedBody {
 public:
  /// Keeps a reference to the body. REQUIRES: `from` is not later than `to`.
  CarriedBody(const Body& body, PlacesAt& from, PlacesAt& to);

  const BodyShape& shape() const { return body_.shape(); }
  MovingBounds bounds(int level, Index block) const;
  /// Of a block of level 0, from where the vertices go: tighter than its box.
  CarriedItems items(Index block) const;

 private:
  double deviation(const Box& at_rest) const;
  MovingBounds cut(const Box& at_start, const Box& at_end) const;

  const Body& body_;
  const double from_, to_;
  RoundedTransform at_from_, at_to_;   ///< of a body that turns; of others where they are at t=0 and t=1
  ChordBounds innermost_, outermost_;  ///< of points as near to the origin of the body's frame as they are, and as far
};

/// Its boxes, made when they are first asked for, and kept: their references stay valid.
class CarriedBoxes {
 public:
  CarriedBoxes(const Body& body, PlacesAt& from, PlacesAt& to);

  const BodyShape& shape() const { return body_.shape(); }
  const MovingBounds& of_block(int level, Index block);
  const CarriedItems& items(Index block);

 private:
  const CarriedBody body_;
  std::vector<std::vector<Index>> place_of_block_;
  std::vector<Index> place_of_items_;
  std::deque<MovingBounds> bounds_;
  std::deque<CarriedItems> items_;
};

}  // namespace tamis

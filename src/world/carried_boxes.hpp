// The boxes of a body's hierarchy during a piece of the step, in the frame of the world.
#pragma once
#include <deque>

#include "world/pieces.hpp"

namespace tamis {

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
  int root_level() const { return shape().boxes.root_level(); }
  MovingBounds bounds(int level, Index block) const;
  /// Of a block of level 0, from where the vertices go: tighter than its box.
  CarriedItems items(Index block) const;

 private:
  double deviation(const Box& at_rest) const;
  MovingBounds cut(const Box& at_start, const Box& at_end) const;

  const Body& body_;
  const double from_, to_;
  PlacedBody at_from_, at_to_;         ///< of a body that turns; of others where they are at t=0 and t=1
  ChordBounds innermost_, outermost_;  ///< of points as near to the origin of the body's frame as they are, and as far
};

/// Its boxes, made when they are first asked for, and kept: their references stay valid.
class CarriedBoxes {
 public:
  CarriedBoxes(const Body& body, PlacesAt& from, PlacesAt& to);

  const BodyShape& shape() const { return body_.shape(); }
  int root_level() const { return body_.root_level(); }
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

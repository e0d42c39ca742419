// One body: its shape, how it moves, and where that takes the boxes of its shape.
#pragma once
#include <memory>
#include <optional>

#include "paths/chain_motion.hpp"
#include "tamis/detector.hpp"
#include "tamis/world.hpp"
#include "world/body_shape.hpp"

namespace tamis {

/// The motions there are, as far as questions differ: vertices that stay, that go straight, that go on curves.
enum class Way : std::uint8_t { still, straight, turning };

class Body {
 public:
  /// Throws InvalidStep, naming the body.
  Body(BodyId id, std::shared_ptr<const BodyShape> shape, BodyMotion motion);
  /// The same, but for its detector.
  Body(const Body& other);
  void move(BodyMotion motion);
  /// Throws InvalidStep, naming the body.
  void validate(const BodyMotion& motion) const;

  const BodyShape& shape() const { return *shape_; }
  const BodyMotion& motion() const { return motion_; }
  Way way() const { return way_; }
  /// What turns, or stays: empty of a body that deforms.
  const Chain& chain() const { return chain_; }
  /// Null unless it deforms.
  const Deforming* deforming() const { return std::get_if<Deforming>(&motion_); }
  Step step() const { return {deforming()->start, deforming()->end}; }

  /// Where a vertex is, rounded to doubles.
  Point start_of(Index vertex) const;
  Point end_of(Index vertex) const;
  /// Hold the body at t=0, and during the whole step.
  const Box& start_hull() const { return start_hull_; }
  const Box& hull() const { return hull_; }
  /// |x''| of its vertices is at most this.
  double acceleration() const { return outermost_.acceleration; }
  std::uint64_t memory_bytes() const;

  bool is_enabled = true;
  bool may_touch_itself = true;
  std::optional<Detector> itself;  ///< of a deforming body: made by the first question

 private:
  friend class CarriedBoxes;

  BodyId id_;
  std::shared_ptr<const BodyShape> shape_;
  BodyMotion motion_;
  Way way_ = Way::still;
  Chain chain_;
  RoundedTransform at_start_, at_end_;
  Curvature innermost_, outermost_;    ///< at the origin of its frame, and as far from it as vertices are
  BoxLevels start_boxes_, end_boxes_;  ///< of a deforming body
  Box start_hull_, hull_;
};

/// A box with axes of its own: its middle, the halves of its edges, and by how much it is to be widened.
struct PlacedBox {
  Point middle;
  std::array<Point, 3> halves;
  double wider;
};

/// The boxes of a body's hierarchy during a piece of the step, in the frame of the world.
class CarriedBoxes {
 public:
  /// Keeps a reference. REQUIRES: 0 <= from <= to <= 1.
  CarriedBoxes(const Body& body, double from, double to);

  const Body& body() const { return body_; }
  MovingBounds of_block(int level, Index block) const;
  MovingBounds of_item(Index item) const;
  int root_level() const { return body_.shape_->boxes.root_level(); }

  /// A box at rest, or one that moves of a body that deforms, as it is placed in the world during the piece.
  PlacedBox placed(const Box& at_rest, const MovingBounds& carried) const;
  PlacedBox placed_block(int level, Index block, const MovingBounds& carried) const {
    return placed(body_.shape_->boxes.box(level, block), carried);
  }
  /// What comes within `separation` of `other` during the piece has a box at rest that meets this one: cheap to ask
  /// first of many boxes. Everything, of a body that deforms.
  Box seen(const PlacedBox& other, double separation) const;

 private:
  /// At one end of the piece.
  struct End {
    RoundedTransform transform;
    double per_size, fixed;  ///< what a box is off by, of size |x|_1 at most
  };
  MovingBounds carried(const Box& at_rest) const;
  MovingBounds between(const Box& start, const Box& end) const;
  double deviation(const Box& at_rest) const;
  End end_at(double time) const;
  double farthest_way() const;

  const Body& body_;
  double from_, to_;
  End at_from_, at_to_;
  Curvature innermost_{0, 0}, outermost_{0, 0};  ///< of the piece: `acceleration` is a deviation
  double way_ = 0;                               ///< no vertex gets farther from where it is at the start of the piece
};

}  // namespace tamis

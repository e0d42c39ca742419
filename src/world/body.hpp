// One body: its shape, and how it moves.
#pragma once
#include <memory>
#include <optional>

#include "curves/chain_motion.hpp"
#include "numerics/held_bytes.hpp"
#include "tamis/detector.hpp"
#include "tamis/world.hpp"
#include "world/body_shape.hpp"

namespace tamis {

/// A step on which bodies turn is cut into no more pieces.
inline constexpr double kMostPieces = 4096;

/// The motions there are, as far as questions differ: vertices that stay, that go straight, that go on curves.
enum class MotionKind : std::uint8_t { still, straight, turning };

/// The chain of a body that does not deform, of a static one from its pose to itself; empty if it deforms.
Chain chain_of(const BodyMotion& motion);

class Body;

/// A record of how a body moved that did not turn, to measure later how far another motion deviates from it.
class StraightMotion {
 public:
  /// REQUIRES: it does not turn.
  explicit StraightMotion(const Body& body);
  /// An upper bound, at all times of the step, of the distance of a vertex from where it was in the recorded motion.
  /// Infinite if the body moves in another manner now.
  double max_deviation(const Body& body) const;
  std::uint64_t memory_bytes() const { return sizeof(*this) + (soft_ ? held_bytes(soft_->start, soft_->end) : 0); }

 private:
  MotionKind motion_kind_;
  RoundedTransform start_, end_;  ///< of a rigid body
  std::optional<Deforming> soft_;
};

class Body {
 public:
  /// Throws InvalidStep, naming the body.
  Body(BodyId id, std::shared_ptr<const BodyShape> shape, BodyMotion motion);
  /// A copy without the detector.
  Body(const Body& other);
  void move(BodyMotion motion);
  /// Throws InvalidStep, naming the body.
  void validate(const BodyMotion& motion) const;

  const BodyShape& shape() const { return *shape_; }
  const BodyMotion& motion() const { return motion_; }
  MotionKind motion_kind() const { return motion_kind_; }
  /// REQUIRES: it turns.
  const Chain& chain() const { return std::get<Rigid>(motion_).chain; }
  /// Are its numbers so small that doubles are sure to tell where it is at all times?
  bool is_surely_representable() const;
  /// Null unless it deforms.
  const Deforming* deforming() const { return std::get_if<Deforming>(&motion_); }
  Step step() const { return {deforming()->start, deforming()->end}; }

  /// Where a vertex is, rounded to doubles.
  Point start_of(Index vertex) const;
  Point end_of(Index vertex) const;
  /// All vertices at a time of the step, with an error bound.
  BodyPoints points_at(double time) const;
  /// Where its frame is at a time of the step; of a body that does not turn at t=0 or 1. Means nothing of a body that
  /// deforms.
  RoundedTransform place_at(double time) const {
    return time == 0 ? at_start_ : time == 1 ? at_end_ : transform_at(chain(), time);
  }
  /// Hold the body at t=0, and during the whole step.
  const Box& start_hull() const { return start_hull_; }
  const Box& hull() const { return hull_; }
  /// Of its points no farther than this from the origin of its frame, and none farther than its farthest vertex.
  Curvature curvature(double from_origin) const;
  /// |x''| of its vertices is at most this.
  double acceleration() const { return outermost_.acceleration; }
  double radius() const { return radius_; }
  void set_radius(double radius);
  /// The detector of a deforming body's contacts with itself. `options`: those of the world.
  Detector& self_detector(const Options& options);
  std::uint64_t memory_bytes() const;

  bool is_enabled = true;
  bool may_touch_itself = true;

 private:
  friend class BodyOnPiece;
  friend class StraightMotion;

  /// Throws InvalidStep if doubles cannot tell where a vertex is. REQUIRES: a body that does not deform, finite poses.
  void validate_far(const Chain& chain) const;

  BodyId id_;
  std::shared_ptr<const BodyShape> shape_;
  BodyMotion motion_;
  MotionKind motion_kind_ = MotionKind::still;
  double radius_ = 0;
  std::optional<Detector> self_detector_;  ///< made by the first question
  RoundedTransform at_start_{}, at_end_{};
  Curvature innermost_, outermost_;  ///< at the origin of its frame, and at the distance of its farthest vertex
  std::vector<Box> start_boxes_, end_boxes_;  ///< of a deforming body, of all nodes
  Box start_hull_, hull_;
};

}  // namespace tamis

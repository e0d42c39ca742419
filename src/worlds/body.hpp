// One body: its shape, and how it moves.
#pragma once
#include <memory>
#include <optional>

#include "curves/motions/chain_motion.hpp"
#include "numbers/held_bytes.hpp"
#include "tamis/detector.hpp"
#include "tamis/world.hpp"
#include "worlds/body_shape.hpp"

namespace tamis {

/// A step on which bodies turn is cut into at most this many pieces.
inline constexpr double kMostPieces = 4096;

/// The kinds of motion that questions tell apart: all vertices stay, go straight, or move on curves.
enum class MotionKind : std::uint8_t { still, straight, turning };

/// The chain of a body that does not deform (a static one's leads from its pose to itself). Empty if it deforms.
RigidChain chain_of(const BodyMotion& motion);

/// The parts of a deforming motion besides itself.
inline std::uint64_t bytes_held_by(const BodyMotion& motion) {
  const auto* soft = std::get_if<Deforming>(&motion);
  return soft ? held_bytes(soft->start, soft->end) : 0;
}

class Body {
 public:
  /// Throws InvalidStep, naming the body.
  Body(BodyId id, std::shared_ptr<const BodyShape> shape, BodyMotion motion);
  /// A copy without the detector.
  Body(const Body& other);
  /// A copy for questions about other bodies, without the first links of its chain. It moves as the frame of these
  /// links sees it. It counts as turning even if no other link turns. REQUIRES: it turns, and has so many links.
  Body(const Body& other, std::size_t links);
  Body(Body&&) noexcept = default;
  Body& operator=(Body&&) noexcept = default;
  /// The body with another motion, of the same kind or another, and without the detector. Throws InvalidStep, naming
  /// the body.
  Body moved(BodyMotion motion) const;
  /// Becomes the result of moved(). A body that deforms before and after keeps its detector. It cannot fail. So a
  /// change of bodies happens as a whole or not at all.
  void become(Body moved) noexcept;
  /// Throws InvalidStep, naming the body.
  void validate(const BodyMotion& motion) const;

  BodyId id() const { return id_; }
  const BodyShape& shape() const { return *shape_; }
  const BodyMotion& motion() const { return motion_; }
  MotionKind motion_kind() const { return motion_kind_; }
  /// REQUIRES: it turns.
  const RigidChain& chain() const { return std::get<Rigid>(motion_).chain; }
  /// True if its numbers are so small that doubles certainly represent its positions at all times.
  bool is_surely_representable() const;
  /// Null unless it deforms.
  const Deforming* deforming() const { return std::get_if<Deforming>(&motion_); }
  Step step() const { return {deforming()->start, deforming()->end}; }

  /// A vertex' position at t=0 and at t=1, rounded to doubles.
  Point start_of(Index vertex) const;
  Point end_of(Index vertex) const;
  /// A vertex at a time of the step. All vertices, with one bound for all.
  RoundedPlace point_at(Index vertex, double time) const;
  BodyPoints points_at(double time) const;
  /// The transform from its frame to the world's at a time of the step. If the body does not turn, only at t=0 or 1.
  /// Means nothing if the body deforms.
  RoundedTransform place_at(double time) const {
    return time == 0 ? at_start_ : time == 1 ? at_end_ : transform_at(chain(), time);
  }
  /// Boxes that hold the body at t=0, and during the whole step.
  const Box& start_hull() const { return start_hull_; }
  const Box& hull() const { return hull_; }
  /// Bounds for all its vertices.
  const Curvature& curvature() const { return curvature_; }
  double radius() const { return radius_; }
  void set_radius(double radius);
  /// The detector of a deforming body's contacts with itself. `options`: the world's.
  Detector& self_detector(const Options& options);
  std::uint64_t memory_bytes() const;

  bool is_enabled = true;
  bool may_touch_itself = true;

 private:
  friend class BodyOnPiece;

  /// f(place_of), place_of(vertex) being where a vertex is at this time, with its error.
  template <class F>
  auto with_places(double time, const F& f) const;

  /// Throws InvalidStep if doubles cannot hold a vertex' position. REQUIRES: a body that does not deform, finite poses.
  void validate_far(const RigidChain& chain) const;

  BodyId id_;
  std::shared_ptr<const BodyShape> shape_;
  BodyMotion motion_;
  MotionKind motion_kind_ = MotionKind::still;
  double radius_ = 0;
  std::optional<Detector> self_detector_;  ///< made by the first question
  RoundedTransform at_start_{}, at_end_{};
  Curvature curvature_{};
  std::vector<Box> start_boxes_, end_boxes_;  ///< of all nodes, if the body deforms
  Box start_hull_, hull_;
};

}  // namespace tamis

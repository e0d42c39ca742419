#include "worlds/body.hpp"

#include <algorithm>
#include <type_traits>

#include "search/topology/at.hpp"
#include "search/topology/points.hpp"
#include "worlds/body_bounds.hpp"

namespace tamis {
namespace {

bool stays(const RigidLink& link) {
  return link.start.position == link.end.position && link.start.rotation == link.end.rotation;
}

}  // namespace

Body::Body(BodyId id, std::shared_ptr<const BodyShape> shape, BodyMotion motion)
    : id_(id), shape_(std::move(shape)), motion_(std::move(motion)) {
  validate(motion_);
  if (const Deforming* soft = deforming()) {
    const auto boxes_at = [&](const std::vector<Point>& points) {
      const auto at_point = [&](Index v) -> const Point& { return points[at(v)]; };
      return shape_->tree.boxes([&](Index item) { return shape_->box_of(item, at_point); });
    };
    start_boxes_ = boxes_at(soft->start);
    end_boxes_ = boxes_at(soft->end);
    motion_kind_ = MotionKind::straight;
  } else {
    const RigidChain chain = chain_of(motion_);
    const ChainBounds bounds(chain);
    curvature_ = bounds.of(shape_->radius, 0);
    motion_kind_ = std::holds_alternative<Static>(motion_) ? MotionKind::still
                   : bounds.turns()                        ? MotionKind::turning
                                                           : MotionKind::straight;
    at_start_ = transform_at(chain, 0);
    at_end_ = std::ranges::all_of(chain, stays) ? at_start_ : transform_at(chain, 1);
  }
  const Index root = shape_->tree.root();
  start_hull_ = BodyOnPiece(*this, 0, 0).bounds(root).hull();
  hull_ = motion_kind_ == MotionKind::still ? start_hull_ : BodyOnPiece(*this, 0, 1).bounds(root).hull();
}

Body::Body(const Body& other) : Body(other.id_, other.shape_, other.motion_) {
  set_radius(other.radius_);
  is_enabled = other.is_enabled;
  may_touch_itself = other.may_touch_itself;
}

Body::Body(const Body& other, std::size_t links) : Body(other.id_, other.shape_, Rigid{without(other.chain(), links)}) {
  motion_kind_ = MotionKind::turning;
  set_radius(other.radius_);
}

Body Body::moved(BodyMotion motion) const {
  Body moved(id_, shape_, std::move(motion));
  moved.radius_ = radius_;
  moved.is_enabled = is_enabled;
  moved.may_touch_itself = may_touch_itself;
  return moved;
}

void Body::become(Body moved) noexcept {
  static_assert(std::is_nothrow_move_assignable_v<BodyMotion> && std::is_nothrow_move_assignable_v<Detector>);
  if (deforming() && moved.deforming()) moved.self_detector_ = std::move(self_detector_);
  *this = std::move(moved);
}

void Body::set_radius(double radius) {
  radius_ = radius;
  self_detector_.reset();
}

Detector& Body::self_detector(const Options& options) {
  if (!self_detector_) {
    Options own = options;
    own.radii = {radius_};
    self_detector_.emplace(shape_->mesh, std::move(own));
  }
  return *self_detector_;
}

Point Body::start_of(Index vertex) const {
  return deforming() ? deforming()->start[at(vertex)] : at_start_.of(shape_->points[at(vertex)]);
}

Point Body::end_of(Index vertex) const {
  return deforming() ? deforming()->end[at(vertex)] : at_end_.of(shape_->points[at(vertex)]);
}

/// Vertices of a body that turns are on their curves. All others move straight from double to double, as in a step.
template <class F>
auto Body::with_places(double time, const F& f) const {
  const bool turns = motion_kind_ == MotionKind::turning;
  const RoundedTransform place = turns ? place_at(time) : RoundedTransform{};
  return f([&](Index v) -> RoundedPlace {
    if (!turns) return rounded_linear(start_of(v), end_of(v), time);
    const Point& x = shape_->points[at(v)];
    return {place.of(x), place.error_of(sum_of_sizes(x), 0)};
  });
}

RoundedPlace Body::point_at(Index vertex, double time) const {
  return with_places(time, [&](const auto& place_of) { return place_of(vertex); });
}

BodyPoints Body::points_at(double time) const {
  return with_places(time, [&](const auto& place_of) {
    BodyPoints found;
    for (Index v = 0; v < shape_->mesh.vertex_count(); ++v) found.points.push_back(place_of(v).x);
    for (const Index v : shape_->mesh.points()) found.error = std::max(found.error, place_of(v).error);
    return found;
  });
}

std::uint64_t Body::memory_bytes() const {
  const std::uint64_t bytes = sizeof(*this) + held_bytes(start_boxes_, end_boxes_) + bytes_held_by(motion_);
  return self_detector_ ? bytes + self_detector_->statistics().memory_bytes : bytes;
}

}  // namespace tamis

#include "world/body.hpp"

#include <string>

#include "numerics/finite.hpp"
#include "tamis/error.hpp"
#include "topology/at.hpp"

namespace tamis {
namespace {

bool is_finite_pose(const Pose& pose) { return is_finite(pose.position) && is_finite(pose.rotation); }

Chain chain_of(const BodyMotion& motion) {
  if (const auto* still = std::get_if<Static>(&motion)) return {{still->pose, still->pose}};
  if (const auto* rigid = std::get_if<Rigid>(&motion)) return rigid->chain;
  return {};
}

/// Of a box that holds rounded positions, for the tests that boxes meet.
Box widened(Box box) {
  box.widen(MovingBounds::kRounding * box.size());
  return box;
}

/// Between two bounds that are linear in `share`, rounded up.
double at_share(double first, double last, double share) {
  return (first + (last - first) * share) * (1 + 0x1p-40) + 0x1p-1000;
}

}  // namespace

Body::Body(BodyId id, std::shared_ptr<const BodyShape> shape, BodyMotion motion) : id_(id), shape_(std::move(shape)) {
  move(std::move(motion));
}

void Body::validate(const BodyMotion& motion) const {
  const std::string name = "body " + std::to_string(id_);
  for (const Link& link : chain_of(motion))
    if (!is_finite_pose(link.start) || !is_finite_pose(link.end))
      throw InvalidStep("a pose of " + name + " is not finite: give finite positions and rotation vectors");
  const auto* deforming = std::get_if<Deforming>(&motion);
  if (!deforming) return;
  for (const auto& [points, when] : {std::pair(&deforming->start, "start"), std::pair(&deforming->end, "end")}) {
    if (points->size() != shape_->points.size())
      throw InvalidStep(name + " has " + std::to_string(points->size()) + " points at the " + when +
                        " of its motion, its shape " + std::to_string(shape_->points.size()) +
                        " vertices: give one point a vertex");
    for (const Index v : shape_->mesh.points())
      if (!is_finite((*points)[at(v)]))
        throw InvalidStep("vertex " + std::to_string(v) + " of " + name + " at the " + when +
                          " of its motion is not finite: give finite points");
  }
}

void Body::move(BodyMotion motion) {
  validate(motion);
  motion_ = std::move(motion);
  chain_ = chain_of(motion_);
  if (const Deforming* soft = deforming()) {
    const auto boxes_at = [&](const std::vector<Point>& points) {
      const auto at_point = [&](Index v) -> const Point& { return points[at(v)]; };
      return BoxLevels(shape_->order, [&](Index item) { return shape_->box_of(item, at_point); });
    };
    start_boxes_ = boxes_at(soft->start);
    end_boxes_ = boxes_at(soft->end);
    innermost_ = outermost_ = {0, 0};
    way_ = Way::straight;
  } else {
    start_boxes_ = end_boxes_ = {};
    itself.reset();
    const ChainBounds bounds(chain_);
    innermost_ = bounds.of(0, 0);
    outermost_ = bounds.of(shape_->radius, 0);
    way_ = std::holds_alternative<Static>(motion_) ? Way::still : bounds.turns() ? Way::turning : Way::straight;
    at_start_ = rounded_transform_of(chain_, 0);
    at_end_ = way_ == Way::still ? at_start_ : rounded_transform_of(chain_, 1);
  }
  const int root = shape_->boxes.root_level();
  start_hull_ = CarriedBoxes(*this, 0, 0).of_block(root, 0).hull();
  hull_ = way_ == Way::still ? start_hull_ : CarriedBoxes(*this, 0, 1).of_block(root, 0).hull();
}

Point Body::start_of(Index vertex) const {
  return deforming() ? deforming()->start[at(vertex)] : at_start_.of(shape_->points[at(vertex)]);
}

Point Body::end_of(Index vertex) const {
  return deforming() ? deforming()->end[at(vertex)] : at_end_.of(shape_->points[at(vertex)]);
}

std::uint64_t Body::memory_bytes() const {
  std::uint64_t bytes = sizeof(*this) + start_boxes_.memory_bytes() + end_boxes_.memory_bytes();
  if (const Deforming* soft = deforming()) bytes += (soft->start.capacity() + soft->end.capacity()) * sizeof(Point);
  if (itself) bytes += itself->statistics().memory_bytes;
  return bytes;
}

CarriedBoxes::CarriedBoxes(const Body& body, double from, double to)
    : body_(body), from_(from), to_(to), at_from_(body.at_start_), at_to_(body.at_end_) {
  TAMIS_ASSERT(0 <= from && from <= to && to <= 1);
  if (body.deforming() || body.way() == Way::still) return;
  const auto at_time = [&](double time) {
    return time == 0 ? body.at_start_ : time == 1 ? body.at_end_ : rounded_transform_of(body.chain_, time);
  };
  at_from_ = at_time(from);
  at_to_ = at_time(to);
}

MovingBounds CarriedBoxes::of_block(int level, Index block) const {
  if (body_.deforming()) return between(body_.start_boxes_.box(level, block), body_.end_boxes_.box(level, block));
  return carried(body_.shape_->boxes.box(level, block));
}

MovingBounds CarriedBoxes::of_item(Index item) const {
  const BodyShape& shape = body_.shape();
  const Deforming* soft = body_.deforming();
  if (!soft) return carried(shape.box_at_rest(item));
  const auto box_of = [&](const std::vector<Point>& points) {
    return shape.box_of(item, [&](Index v) -> const Point& { return points[at(v)]; });
  };
  return between(box_of(soft->start), box_of(soft->end));
}

/// The vertices go straight: linear bounds between those of both ends hold.
MovingBounds CarriedBoxes::between(const Box& start, const Box& end) const {
  const auto at_time = [&](double time) {
    if (time == 0) return widened(start);
    if (time == 1) return widened(end);
    Box box;
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = (1 - time) * start.low[k] + time * end.low[k];
      box.high[k] = (1 - time) * start.high[k] + time * end.high[k];
    }
    box.widen(MovingBounds::kRounding * std::max(start.size(), end.size()));
    return widened(box);
  };
  return {at_time(from_), at_time(to_)};
}

/// Of a vertex within the box, from its chord.
double CarriedBoxes::deviation(const Box& at_rest) const {
  if (body_.way_ != Way::turning) return 0;
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double farthest = std::max(std::fabs(at_rest.low[k]), std::fabs(at_rest.high[k]));
    square += farthest * farthest;
  }
  const double radius = body_.shape_->radius, place = std::sqrt(square) * (1 + 0x1p-40);
  const double share = place < radius ? place / radius : 1;  // corners may be farther than all vertices
  const Curvature &first = body_.innermost_, &last = body_.outermost_;
  const Curvature curve{at_share(first.acceleration, last.acceleration, share),
                        at_share(first.reach, last.reach, share)};
  return curve.deviation(Interval(to_) - Interval(from_));
}

/// A rotation takes a box around a middle to one around where that goes.
MovingBounds CarriedBoxes::carried(const Box& at_rest) const {
  const Point middle = at_rest.middle();
  Point half{};
  double size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    half[k] = std::max(at_rest.high[k] - middle[k], middle[k] - at_rest.low[k]);
    size += std::fabs(middle[k]) + half[k];
  }
  const double deviation = this->deviation(at_rest);
  const auto by = [&](const RoundedTransform& transform) {
    const Point center = transform.of(middle);
    Box box;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& row = transform.rows[k];
      const double reach = std::fabs(row[0]) * half[0] + std::fabs(row[1]) * half[1] + std::fabs(row[2]) * half[2];
      box.low[k] = center[k] - reach;
      box.high[k] = center[k] + reach;
    }
    box.widen(transform.error_of(size, 0) + deviation);
    return widened(box);
  };
  return {by(at_from_), by(at_to_)};
}

}  // namespace tamis

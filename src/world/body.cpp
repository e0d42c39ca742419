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

Body::Body(const Body& other) : Body(other.id_, other.shape_, other.motion_) {
  is_enabled = other.is_enabled;
  may_touch_itself = other.may_touch_itself;
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
    : body_(body), from_(from), to_(to), at_from_(end_at(from)), at_to_(end_at(to)) {
  TAMIS_ASSERT(0 <= from && from <= to && to <= 1);
  if (body.way_ == Way::turning) {
    const Interval length = Interval(to) - Interval(from);
    const Interval eighth = Interval(0.125) * length * length;
    const auto of_piece = [&](const Curvature& curve) {
      return Curvature{(eighth * Interval(curve.acceleration)).upper, 2 * curve.reach};
    };
    innermost_ = of_piece(body.innermost_);
    outermost_ = of_piece(body.outermost_);
  }
  if (body.way_ != Way::still && !body.deforming()) way_ = farthest_way();
}

CarriedBoxes::End CarriedBoxes::end_at(double time) const {
  const bool is_known = time == 0 || body_.way_ == Way::still || body_.deforming();
  const RoundedTransform transform = is_known    ? body_.at_start_
                                     : time == 1 ? body_.at_end_
                                                 : rounded_transform_of(body_.chain_, time);
  const double fixed = transform.error_of(0, 0), per_size = transform.error_of(1, 0) - fixed;
  // No coordinate of a box is larger than its size and the shift together, but for what is added here.
  return {transform, per_size * (1 + 0x1p-20) + 2 * MovingBounds::kRounding,
          fixed * (1 + 0x1p-20) + 2 * MovingBounds::kRounding * transform.shift_size};
}

/// |R1 x + p1 - R0 x - p0|, and what the curve and rounding may add.
double CarriedBoxes::farthest_way() const {
  const RoundedTransform &a = at_from_.transform, &b = at_to_.transform;
  double turn = 0, shift = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    shift += (b.shift[i] - a.shift[i]) * (b.shift[i] - a.shift[i]);
    for (std::size_t k = 0; k < 3; ++k) turn += (b.rows[i][k] - a.rows[i][k]) * (b.rows[i][k] - a.rows[i][k]);
  }
  const double radius = body_.shape_->radius, size = 1.8 * radius;  // |x|_1 <= sqrt(3) |x|
  const double off = 2 * ((at_from_.per_size + at_to_.per_size) * size + at_from_.fixed + at_to_.fixed);
  const double deviation = std::min(outermost_.acceleration, outermost_.reach);
  return (std::sqrt(turn) * radius + std::sqrt(shift) + deviation + off) * (1 + 0x1p-20);
}

namespace {

struct Halves {
  Point middle, half;
  double size;  ///< no |x|_1 within is larger
};

Halves halves_of(const Box& box) {
  Halves halves{box.middle(), {}, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    halves.half[k] = std::max(box.high[k] - halves.middle[k], halves.middle[k] - box.low[k]);
    halves.size += std::fabs(halves.middle[k]) + halves.half[k];
  }
  return halves;
}

}  // namespace

PlacedBox CarriedBoxes::placed(const Box& at_rest, const MovingBounds& carried) const {
  const bool is_soft = body_.deforming();
  const Halves box = halves_of(is_soft ? carried.hull() : at_rest);
  PlacedBox placed{box.middle, {}, MovingBounds::kRounding * box.size};
  for (std::size_t k = 0; k < 3; ++k) placed.halves[k][k] = box.half[k];
  if (is_soft) return placed;
  const auto& [transform, per_size, fixed] = at_from_;
  placed.middle = transform.of(box.middle);
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t j = 0; j < 3; ++j) placed.halves[j][k] = transform.rows[k][j] * box.half[j];
  placed.wider = 2 * (per_size * box.size + fixed) + way_;
  return placed;
}

/// In the frame of the body as it stands at the start of the piece. The inverse is the transpose, but for what the rows
/// are off by.
Box CarriedBoxes::seen(const PlacedBox& other, double separation) const {
  constexpr double far = Box::kNone;
  if (body_.deforming()) return {{-far, -far, -far}, {far, far, far}};
  const auto& [transform, per_size, fixed] = at_from_;
  const auto turned_back = [&transform = transform](const Point& x, std::size_t k) {
    return transform.rows[0][k] * x[0] + transform.rows[1][k] * x[1] + transform.rows[2][k] * x[2];
  };
  const double near = separation + way_ + other.wider;
  double size = transform.shift_size + near;
  Point from_shift{};
  for (std::size_t k = 0; k < 3; ++k) {
    from_shift[k] = other.middle[k] - transform.shift[k];
    size += std::fabs(other.middle[k]);
    for (const Point& half : other.halves) size += std::fabs(half[k]);
  }
  Box box;
  for (std::size_t k = 0; k < 3; ++k) {
    double reach = near + 4 * (per_size * size + fixed);
    for (const Point& half : other.halves) reach += std::fabs(turned_back(half, k));
    const double center = turned_back(from_shift, k);
    box.low[k] = center - reach;
    box.high[k] = center + reach;
  }
  return box;
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
  return std::min(at_share(innermost_.acceleration, outermost_.acceleration, share),
                  at_share(innermost_.reach, outermost_.reach, share));
}

/// A rotation takes a box around a middle to one around where that goes.
MovingBounds CarriedBoxes::carried(const Box& at_rest) const {
  const auto [middle, half, size] = halves_of(at_rest);
  const double deviation = this->deviation(at_rest);
  const auto by = [&, &middle = middle, &half = half, &size = size](const End& end) {
    const RoundedTransform& transform = end.transform;
    const Point center = transform.of(middle);
    const double off = end.per_size * size + end.fixed + deviation * (1 + MovingBounds::kRounding);
    Box box;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& row = transform.rows[k];
      const double reach =
          std::fabs(row[0]) * half[0] + std::fabs(row[1]) * half[1] + std::fabs(row[2]) * half[2] + off;
      box.low[k] = center[k] - reach;
      box.high[k] = center[k] + reach;
    }
    return box;
  };
  return {by(at_from_), by(at_to_)};
}

}  // namespace tamis

#include "worlds/body_bounds.hpp"

#include <algorithm>
#include <cmath>

#include "curves/motions/curvature.hpp"
#include "numbers/assert.hpp"
#include "search/topology/at.hpp"

namespace tamis {
namespace {

/// Widens a box for the rounding of may_meet().
Box widened(Box box) {
  box.widen(MovingBounds::kRounding * box.largest_coordinate());
  return box;
}

/// Makes a box unbounded along axes with NaN. NaN appears where the bend of curves overflows.
Box unbounded_if_unknown(Box box) {
  for (std::size_t k = 0; k < 3; ++k)
    if (!(box.low[k] <= box.high[k])) box.low[k] = -kUnbounded, box.high[k] = kUnbounded;
  return box;
}

/// An error bound of transformed points with |x|_1 <= size, and of their boxes, the rounding of may_meet() included. No
/// coordinate of a box exceeds `size` plus the shift's size by more than this bound.
double rounding_bound(const RoundedTransform& place, double size) {
  return place.error_of(size, 0) + 2 * MovingBounds::kRounding * (size + place.shift_size);
}

/// A box in the frame of the world that holds the box `at_rest` of the body's frame at `place`, widened by `wider`. It
/// is around the transformed center. Its half edges are |R| times the half edges at rest.
Box box_in_world(const Box& at_rest, const RoundedTransform& place, double wider) {
  const Point middle = at_rest.middle();
  Point half{};
  double size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    half[k] = std::max(at_rest.high[k] - middle[k], middle[k] - at_rest.low[k]);
    size += std::fabs(middle[k]) + half[k];
  }
  const Point center = place.of(middle);
  Box box;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point& row = place.rows[k];
    const double extent = std::fabs(row[0]) * half[0] + std::fabs(row[1]) * half[1] + std::fabs(row[2]) * half[2];
    const double wide = extent + rounding_bound(place, size) + wider;
    box.low[k] = center[k] - wide;
    box.high[k] = center[k] + wide;
  }
  return box;
}

}  // namespace

BodyOnPiece::BodyOnPiece(const Body& body, double from, double to) : body_(body), from_(from), to_(to) {
  TAMIS_ASSERT(0 <= from && from <= to && to <= 1);
  const bool turns = body.motion_kind() == MotionKind::turning;
  if (turns) {
    const Interval factor = chord_factor(Interval(to) - Interval(from));
    deviation_ = body.curvature().deviation(factor) * (1 + MovingBounds::kRounding);
  }
  at_from_ = body.place_at(turns ? from : 0);
  at_to_ = body.place_at(turns ? to : 1);
}

MovingBounds BodyOnPiece::bounds(Index node) const {
  if (body_.deforming()) return cut(widened(body_.start_boxes_[at(node)]), widened(body_.end_boxes_[at(node)]));
  const Box& at_rest = shape().boxes[at(node)];
  return cut(box_in_world(at_rest, at_from_, deviation_), box_in_world(at_rest, at_to_, deviation_));
}

ItemBounds BodyOnPiece::items(Index leaf) const {
  ItemBounds result;
  const auto items = shape().tree.items_of(leaf);
  const Box& at_rest = shape().boxes[at(leaf)];
  const bool turns = body_.motion_kind() == MotionKind::turning;
  const double size = at_rest.largest_sum();
  const auto placed = [&](const RoundedTransform& place, const auto& end_of_vertex, Index item) {
    if (!turns) return widened(shape().box_of(item, end_of_vertex));
    Box box = shape().box_of(item, [&](Index v) { return place.of(shape().points[at(v)]); });
    box.widen(rounding_bound(place, size) + deviation_);
    return box;
  };
  for (std::size_t i = 0; i < items.size(); ++i) {
    result.of_item[i] = cut(placed(
                                at_from_, [&](Index v) { return body_.start_of(v); }, items[i]),
                            placed(
                                at_to_, [&](Index v) { return body_.end_of(v); }, items[i]));
    result.all.start.include(result.of_item[i].start);
    result.all.end.include(result.of_item[i].end);
  }
  return result;
}

/// Restricts bounds to the piece. Vertices of a body that does not turn move straight during the whole step. So its
/// bounds at both ends are interpolated. The bounds of a body that turns are of the piece already.
MovingBounds BodyOnPiece::cut(const Box& at_start, const Box& at_end) const {
  const Box start = unbounded_if_unknown(at_start), end = unbounded_if_unknown(at_end);
  if (body_.motion_kind() != MotionKind::straight) return {start, end};
  const auto at_time = [&](double time) {
    if (time == 0) return start;
    if (time == 1) return end;
    Box box;
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = (1 - time) * start.low[k] + time * end.low[k];
      box.high[k] = (1 - time) * start.high[k] + time * end.high[k];
    }
    box.widen(MovingBounds::kRounding * std::max(start.largest_coordinate(), end.largest_coordinate()));
    return box;
  };
  return {at_time(from_), at_time(to_)};
}

BoundsOnPiece::BoundsOnPiece(const Body& body, double from, double to)
    : body_(body, from, to), bounds_(at(shape().tree.node_count())), items_(at(shape().tree.leaf_count())) {}

const MovingBounds& BoundsOnPiece::bounds(Index node) {
  const MovingBounds*& bounds = bounds_[at(node)];
  if (!bounds) bounds = &made_.emplace_back(body_.bounds(node));
  return *bounds;
}

const ItemBounds& BoundsOnPiece::items(Index leaf) {
  auto& items = items_[at(leaf)];
  if (!items) items = std::make_unique<const ItemBounds>(body_.items(leaf));
  return *items;
}

}  // namespace tamis

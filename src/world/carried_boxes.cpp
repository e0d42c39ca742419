#include "world/carried_boxes.hpp"

#include "curves/fine_point.hpp"
#include "numerics/assert.hpp"
#include "numerics/error_bounds.hpp"
#include "topology/at.hpp"

namespace tamis {
namespace {

constexpr Index kNotMade = -1;

/// Of a box that holds rounded positions, for the tests that boxes meet.
Box widened(Box box) {
  box.widen(MovingBounds::kRounding * box.largest_coordinate());
  return box;
}

/// What is not a number, as where curves bend by more than doubles can say, may be anywhere: so that a box that
/// includes it is as large.
Box all_if_unknown(Box box) {
  for (std::size_t k = 0; k < 3; ++k)
    if (!(box.low[k] <= box.high[k])) box.low[k] = -kUnbounded, box.high[k] = kUnbounded;
  return box;
}

/// Between two bounds that are linear in `share`, rounded up.
double at_share(double first, double last, double share) {
  return (first + (last - first) * share) * kRoundedUp + 0x1p-1000;
}

/// No point within is farther from the origin.
double farthest_in(const Box& box) {
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double farthest = std::max(std::fabs(box.low[k]), std::fabs(box.high[k]));
    square += farthest * farthest;
  }
  return std::sqrt(square) * kRoundedUp;
}

/// What is kept in `kept` at a place, made if it is asked for first.
template <class Kept, class Make>
const typename Kept::value_type& kept_at(Index& place, Kept& kept, const Make& make) {
  if (place == kNotMade) {
    place = static_cast<Index>(kept.size());
    kept.push_back(make());
  }
  return kept[at(place)];
}

}  // namespace

CarriedBody::CarriedBody(const Body& body, PlacesAt& from, PlacesAt& to)
    : body_(body), from_(from.time()), to_(to.time()), at_from_(body.at_start()), at_to_(body.at_end()) {
  TAMIS_ASSERT(0 <= from_ && from_ <= to_ && to_ <= 1);
  if (body.motion_kind() != MotionKind::turning) return;
  at_from_ = from.of(body);
  at_to_ = to.of(body);
  const Interval length = Interval(to_) - Interval(from_);
  const auto of_piece = [&](const Curvature& curve) {
    return ChordBounds{chord_deviation(curve.acceleration, length), 2 * curve.reach};
  };
  innermost_ = of_piece(body.innermost_);
  outermost_ = of_piece(body.outermost_);
}

/// Of vertices within the box, from their chords.
double CarriedBody::deviation(const Box& at_rest) const {
  if (body_.motion_kind() != MotionKind::turning) return 0;
  const double radius = shape().radius, place = farthest_in(at_rest);
  const double share = place < radius ? place / radius : 1;  // corners may be farther than all vertices
  return std::min(at_share(innermost_.by_acceleration, outermost_.by_acceleration, share),
                  at_share(innermost_.by_reach, outermost_.by_reach, share)) *
         (1 + MovingBounds::kRounding);
}

MovingBounds CarriedBody::bounds(int level, Index block) const {
  if (body_.deforming())
    return cut(widened(body_.start_boxes_.box(level, block)), widened(body_.end_boxes_.box(level, block)));
  const Box& at_rest = shape().boxes.box(level, block);
  const double deviation = this->deviation(at_rest);
  return cut(carried(at_rest, at_from_, deviation), carried(at_rest, at_to_, deviation));
}

CarriedItems CarriedBody::items(Index block) const {
  CarriedItems result;
  const auto items = shape().order.items_of(block);
  const Box& at_rest = shape().boxes.box(0, block);
  const bool turns = body_.motion_kind() == MotionKind::turning;
  const double size = at_rest.largest_sum(), deviation = this->deviation(at_rest);
  const auto placed = [&](const RoundedTransform& place, const auto& end_of_vertex, Index item) {
    if (!turns) return widened(shape().box_of(item, end_of_vertex));
    Box box = shape().box_of(item, [&](Index v) { return place.of(shape().points[at(v)]); });
    box.widen(off_by(place, size) + deviation);
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

/// Vertices of a body that does not turn go straight during the whole step: linear bounds between those of both ends
/// hold. Those of one that turns are of the piece already.
MovingBounds CarriedBody::cut(const Box& at_start, const Box& at_end) const {
  const Box start = all_if_unknown(at_start), end = all_if_unknown(at_end);
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

CarriedBoxes::CarriedBoxes(const Body& body, PlacesAt& from, PlacesAt& to) : body_(body, from, to) {
  for (int level = 0; level <= shape().boxes.root_level(); ++level)
    place_of_block_.emplace_back(shape().boxes.level(level).size(), kNotMade);
  place_of_items_ = place_of_block_[0];
}

const MovingBounds& CarriedBoxes::of_block(int level, Index block) {
  return kept_at(place_of_block_[at(level)][at(block)], bounds_, [&] { return body_.bounds(level, block); });
}

const CarriedItems& CarriedBoxes::items(Index block) {
  return kept_at(place_of_items_[at(block)], items_, [&] { return body_.items(block); });
}

}  // namespace tamis

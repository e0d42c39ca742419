#include "worlds/edge_motion.hpp"

#include <cmath>

#include "curves/motions/rounded_rotation.hpp"
#include "numbers/length.hpp"
#include "search/topology/at.hpp"

namespace tamis {
namespace {

/// Rounded up. Differences round once, by a part of themselves.
double change_above(const Point& a, const Point& b) {
  return length_of(b[0] - a[0], b[1] - a[1], b[2] - a[2]) * kRoundedUp + 0x1p-1000;
}
double farthest_above(const Pose& a, const Pose& b) {
  return std::max(change_above({0, 0, 0}, a.position), change_above({0, 0, 0}, b.position));
}

constexpr double kTurn = 6.283185307179586;  // 2 pi, off by less than 2^-51

/// A link that turns farther than rounded_rotation() allows. Whole turns are taken off the rotation vector w: w (1 -
/// 2 pi k / |w|) has the same rotation. The factor is off by less than 2^-50 in doubles. 2 pi k, which is at most 2
/// |w|, is off by less than 2^-52 of itself. So the new vector is off by less than 2^-48 |w|; 2^-46 are given.
RoundedTransform far_link(const RigidLink& link, double time) {
  const RoundedPlace turn = rounded_linear(link.start.rotation, link.end.rotation, time);
  const RoundedPlace shift = rounded_linear(link.start.position, link.end.position, time);
  const double length = length_of(turn.x[0], turn.x[1], turn.x[2]);
  const double factor = length > 1 ? 1 - kTurn * std::floor(length / kTurn + 0.5) / length : 1;
  const Point rest{factor * turn.x[0], factor * turn.x[1], factor * turn.x[2]};
  const RoundedRotation rotation = rounded_rotation(rest, 2 * turn.error + 0x1p-46 * length);
  RoundedTransform place{rotation.rows, shift.x, rotation.error, shift.error, 0};
  for (const double x : place.shift) place.shift_size = std::max(place.shift_size, std::fabs(x));
  return place;
}

/// Radians beyond which doubles would leave few bits of an angle.
constexpr double kLargestAngle = 0x1p20;

}  // namespace

Bend::Bend(const Curvature& at_origin, const Curvature& at_radius, double radius) {
  // Both bounds are linear in the distance from the origin, but for rounding.
  const double scale = radius > 0 ? 1 / radius : 0;
  acceleration_ = at_origin.acceleration;
  acceleration_slope_ = std::max(0., at_radius.acceleration * kRoundedUp - at_origin.acceleration) * scale * kRoundedUp;
  orbit_ = at_origin.orbit_radius;
  orbit_slope_ = std::max(0., at_radius.orbit_radius * kRoundedUp - at_origin.orbit_radius) * scale * kRoundedUp;
}

BodyOnEdge::BodyOnEdge(const BodyShape& shape, bool stays)
    : shape_(&shape),
      size_(shape.boxes[at(shape.tree.root())].largest_sum()),
      stays_(stays),
      edge_of_(stays ? 1 : kTimes),
      places_(edge_of_.size()),
      boxes_(shape.boxes.begin(), shape.boxes.end()),
      leaves_(at(shape.tree.leaf_count()) * (stays ? 1 : 3)) {}

Triangle BodyOnEdge::corners_at(const RoundedTransform& place, Index item) const {
  const Face corners = shape_->corners_of(item);
  Triangle found;
  for (std::size_t k = 0; k < 3; ++k) found[k] = place.of(shape_->points[at(corners[k])]);
  return found;
}

const PlacedLeaf& BodyOnEdge::leaf_at(std::size_t time, const RoundedTransform& place, Index leaf, std::size_t slot) {
  if (stays_) time = 0;
  std::unique_ptr<PlacedLeaf>& kept = leaves_[stays_ ? at(leaf) : 3 * at(leaf) + slot];
  if (!kept) kept = std::make_unique<PlacedLeaf>();
  if (kept->edge == edge_ && kept->time == time) return *kept;
  kept->edge = edge_;
  kept->time = time;
  kept->all = {};
  const auto items = shape_->tree.items_of(leaf);
  for (std::size_t k = 0; k < items.size(); ++k) {
    kept->corners[k] = corners_at(place, items[k]);
    kept->boxes[k] = {};
    for (const Point& corner : kept->corners[k]) kept->boxes[k].include(corner);
    kept->all.include(kept->boxes[k]);
  }
  return *kept;
}

/// Along a direction of length 1 the errors of three axes add up to less than 2 of one. Questions take vertices that go
/// straight where their ends round to doubles, off by as much again. Projections of places and of boxes are sums of
/// fewer than 32 products of numbers below 2 (size + shift).
PlaceOnEdge BodyOnEdge::with_margin(const RoundedTransform& place) const {
  return {place, (4 * place.error_of(size_, 0) + 0x1p-44 * (size_ + place.shift_size)) * kRoundedUp};
}

void LinksOnEdge::begin(std::span<const double> start, std::span<const double> end) {
  ++edge_;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const LinkageTree::Link& link = tree_.links[i];
    links_[i] = {link.pose(start[at(link.coordinate)]), link.pose(end[at(link.coordinate)])};
  }
}

RoundedTransform LinksOnEdge::own_place_of(std::size_t link, std::size_t time) {
  const RigidLink& own = links_[link];
  const auto length = [](const Pose& pose) { return length_of(pose.rotation[0], pose.rotation[1], pose.rotation[2]); };
  const double farthest = std::max(length(own.start), length(own.end));
  const bool is_far = farthest > kLargestRoundedAngle && farthest < kLargestAngle;
  return with_norms(is_far ? far_link(own, time_of(time)) : rounded_link(own, time_of(time)));
}

const RoundedTransform& LinksOnEdge::place_of(Index link, Index frame, std::size_t time) {
  Times& times = frames_[at(frame + 1)][at(link)];
  if (times.edge_of.empty()) times.edge_of.resize(kTimes), times.places.resize(kTimes);
  if (times.edge_of[time] != edge_) {
    const Index parent = tree_.links[at(link)].parent;
    times.places[time] = parent == frame ? own_place_of(at(link), time)
                                         : after(place_of(parent, frame, time), place_of(link, parent, time));
    times.edge_of[time] = edge_;
  }
  return times.places[time];
}

RoundedTransform LinksOnEdge::place_of(const LinkageTree::Carried& body, Index frame, std::size_t time) {
  const bool is_of_frame = body.link == frame;
  if (is_of_frame) return with_norms(rounded_link({body.place, body.place}, 0));
  const RoundedTransform& link = place_of(body.link, frame, time);
  return body.is_in_place() ? link : after(link, with_norms(rounded_link({body.place, body.place}, 0)));
}

/// As ChainBounds::of, in doubles that are rounded up at the end.
Bend LinksOnEdge::bend_of(const LinkageTree::Carried& body, Index frame, double radius) const {
  const auto curvature_of = [&](double from_origin) {
    double place = from_origin + farthest_above(body.place, body.place), speed = 0, acceleration = 0, orbit = 0;
    bool is_outermost = true;
    for (Index link = body.link; link != frame; link = tree_.links[at(link)].parent) {
      const auto& [start, end] = links_[at(link)];
      const double turn = start.rotation == end.rotation ? 0 : change_above(start.rotation, end.rotation);
      orbit = place;
      acceleration = turn * turn * place + 2 * turn * speed + acceleration;
      speed = turn * place + speed + (start.position == end.position ? 0 : change_above(start.position, end.position));
      place += farthest_above(start, end);
      is_outermost = false;
    }
    return is_outermost ? Curvature{0, 0} : Curvature{acceleration * kRoundedUp, orbit * kRoundedUp};
  };
  return {curvature_of(0), curvature_of(radius), radius};
}

}  // namespace tamis

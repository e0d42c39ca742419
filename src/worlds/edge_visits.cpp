// Proves two nodes, or two items, apart on a piece of an edge, or replaces them by their parts.
#include <algorithm>
#include <cmath>

#include "search/topology/at.hpp"
#include "worlds/edge_prover.hpp"

namespace tamis {

void EdgeProver::visit(const Piece& piece, const Item& item) {
  ++now_->visits;
  if (item.a < 0) return visit_items(piece, item);
  const BodyShape &shape_a = piece.a->shape(), &shape_b = piece.b->shape();
  const MiddleBox &a = piece.a->box(item.a), &b = piece.b->box(item.b);
  const double deviation = piece.deviation(a.reach, b.reach);
  std::array<Point, 3> way;
  for (std::size_t i = 0; i < 3; ++i)
    way[i] = difference(piece.at_b[i]->place.of(b.middle), piece.at_a[i]->place.of(a.middle));
  // Balls around the boxes.
  const double balls = (a.radius + b.radius) * kRoundedUp, length = std::sqrt(dot(way[1], way[1]));
  if (length > balls + piece.separation) {
    const Point direction{way[1][0] / length, way[1][1] / length, way[1][2] / length};
    if (piece.proves(dot(direction, way[0]) - balls, dot(direction, way[2]) - balls, deviation)) return;
  }
  Gap gap = gap_of(a, piece.at_a[1]->place, b, piece.at_b[1]->place);
  const Point moved = difference(way[2], way[0]);
  double loss = std::sqrt(dot(moved, moved)) + deviation;
  const auto is_proven = [&](const auto& width_at) {
    if (!(gap.width > piece.separation)) return false;
    const double at_start = width_at(0), at_end = width_at(2);
    loss = gap.width - std::min(at_start, at_end) + deviation;
    return piece.proves(at_start, at_end, deviation);
  };
  if (is_proven([&](std::size_t i) {
        return dot(gap.direction, way[i]) - a.extent(piece.at_a[i]->place, gap.direction) -
               b.extent(piece.at_b[i]->place, gap.direction);
      }))
    return;
  const bool are_leaves = shape_a.tree.is_leaf(item.a) && shape_b.tree.is_leaf(item.b);
  if (are_leaves) {  // by the very points, along the same direction
    const Point back{-gap.direction[0], -gap.direction[1], -gap.direction[2]};
    const auto width_at = [&](std::size_t i) {
      return -support(*piece.b, piece.at_b[i]->place, item.b, back) -
             support(*piece.a, piece.at_a[i]->place, item.a, gap.direction);
    };
    gap.width = width_at(1);
    if (is_proven(width_at)) return;
  }
  now_->is_near = true;  // from here on not by whole bodies
  // Where most is lost by the motion, a shorter piece proves more than smaller boxes.
  constexpr double kLargeLoss = 0.25, kLargeLossOfLeaves = 0.5;
  const bool splits_a = splits_first(piece, item);
  const double size = are_leaves ? std::min(a.radius, b.radius) : splits_a ? a.radius : b.radius;
  if (loss > (are_leaves ? kLargeLossOfLeaves : kLargeLoss) * size) {
    next_.push_back(item);
    if (gap.width <= 0 && !(ends_at_collision_ && piece.level < kProbedLevels)) probe(piece, item);
  } else if (are_leaves) {
    visit_leaves(piece, item);
  } else {
    for_each_part(piece, item, splits_a, [&](const Item& part) { stack_.push_back(part); });
  }
}

/// How far the items of a leaf reach along a direction.
double EdgeProver::support(const BodyOnEdge& body, const RoundedTransform& place, Index leaf, const Point& direction) {
  const BodyShape& shape = body.shape();
  const Point own{dot(column(place, 0), direction), dot(column(place, 1), direction), dot(column(place, 2), direction)};
  double farthest = -kUnbounded;
  for (const Index item : shape.tree.items_of(leaf))
    for (const Index v : shape.corners_of(item)) farthest = std::max(farthest, dot(shape.points[at(v)], own));
  return farthest + dot(place.shift, direction);
}

/// True if of two nodes the first is to be replaced by its children: the larger one that has any.
bool EdgeProver::splits_first(const Piece& piece, const Item& item) {
  if (piece.b->shape().tree.is_leaf(item.b)) return true;
  return !piece.a->shape().tree.is_leaf(item.a) && piece.a->box(item.a).radius >= piece.b->box(item.b).radius;
}

/// The hulls of the items on the piece are compared, axis by axis.
void EdgeProver::visit_leaves(const Piece& piece, const Item& leaves) {
  const auto items_a = piece.a->shape().tree.items_of(leaves.a), items_b = piece.b->shape().tree.items_of(leaves.b);
  const double deviation = piece.deviation(piece.a->box(leaves.a).reach, piece.b->box(leaves.b).reach);
  const double wider = (piece.separation + deviation + std::max(piece.margin[0], piece.margin[2])) * kRoundedUp;
  const PlacedLeaf &a0 = piece.leaf_of_a(leaves.a, 0), &a1 = piece.leaf_of_a(leaves.a, 2);
  const PlacedLeaf &b0 = piece.leaf_of_b(leaves.b, 0), &b1 = piece.leaf_of_b(leaves.b, 2);
  std::array<Box, kBlock> hull_b;
  for (std::size_t k = 0; k < items_b.size(); ++k) hull_b[k] = joined(b0.boxes[k], b1.boxes[k]);
  const Box all_b = joined(b0.all, b1.all);
  for (std::size_t i = 0; i < items_a.size(); ++i) {
    Box hull = joined(a0.boxes[i], a1.boxes[i]);
    hull.widen(wider);
    if (!may_meet(hull, all_b)) continue;
    for (std::size_t k = 0; k < items_b.size(); ++k)
      if (may_meet(hull, hull_b[k])) stack_.push_back({-1 - items_a[i], -1 - items_b[k]});
  }
}

void EdgeProver::visit_items(const Piece& piece, const Item& items) {
  const Index item_a = -1 - items.a, item_b = -1 - items.b;
  const auto corners = [&](std::size_t i) {
    return std::pair(piece.a->corners_at(piece.at_a[i]->place, item_a),
                     piece.b->corners_at(piece.at_b[i]->place, item_b));
  };
  const auto [a, b] = corners(1);
  const Gap gap = gap_of(a, b);
  if (gap.width > piece.separation) {
    const double deviation = piece.deviation(MiddleBox(piece.a->shape().box_at_rest(item_a)).reach,
                                             MiddleBox(piece.b->shape().box_at_rest(item_b)).reach);
    const auto width_at = [&](std::size_t i) {
      const auto [start, end] = corners(i);
      return width_along(gap.direction, start, end);
    };
    if (piece.proves(width_at(0), width_at(2), deviation)) return;
  } else if (!(gap.width > 0) && surely_meet(a, b, piece.margin[1])) {
    return collide(piece);
  }
  next_.push_back(items);
}

}  // namespace tamis

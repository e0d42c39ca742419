#include "worlds/edge_prover.hpp"

#include <algorithm>
#include <cmath>

#include "search/query/cancellation.hpp"
#include "search/topology/at.hpp"

namespace tamis {
namespace {

constexpr int kLastLevel = kFinest - 1;
/// Visits of one pair on one edge, after which a detector decides it.
constexpr int kMostVisits = 1 << 14;

/// The last link that carries both; -1: the world.
Index common_link(const LinkageTree& tree, Index a, Index b) {
  while (a != b) (a > b ? a : b) = tree.links[at(std::max(a, b))].parent;
  return a;
}

}  // namespace

EdgeProver::EdgeProver(const BodyList& bodies, const LinkageTree& tree, const std::set<BodyPair>& excluded,
                       double separation)
    : bodies_(bodies),
      tree_(tree),
      separation_(separation),
      links_(tree),
      carried_of_(bodies.size(), -1),
      others_(bodies.size()),
      frames_(tree.links.size() + 1),
      still_(bodies, true, {.separation = separation}) {
  const std::size_t count = tree.bodies.size();
  for (std::size_t i = 0; i < count; ++i) carried_of_[at(tree.bodies[i])] = static_cast<Index>(i);
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<char>& row = may_meet_.emplace_back(bodies.size());
    for (std::size_t id = 0; id < bodies.size(); ++id) {
      const BodyId body = tree.bodies[i], other = static_cast<BodyId>(id);
      row[id] = bodies[id] && bodies[id]->is_enabled && bodies[at(body)]->is_enabled && body != other &&
                !excluded.contains({std::min(body, other), std::max(body, other)});
    }
    std::vector<Index>& links = common_.emplace_back();
    for (std::size_t k = 0; k < count; ++k)
      links.push_back(common_link(tree, tree.carried[i].link, tree.carried[k].link));
  }
  for (auto& frame : frames_) frame.resize(count);
  for (std::size_t id = 0; id < bodies.size(); ++id) {
    if (!bodies[id] || carried_of_[id] >= 0 || bodies[id]->deforming()) continue;
    const Body& body = *bodies[id];
    const bool stays = body.motion_kind() == MotionKind::still;
    others_[id] = std::make_unique<BodyOnEdge>(body.shape(), stays);
    if (stays) continue;
    const ChainBounds bounds(body.chain());
    const double radius = body.shape().radius;
    others_[id]->begin(bounds.turns() ? Bend(bounds.of(0, 0), bounds.of(radius, 0), radius) : Bend());
    if (body.is_enabled) moving_.push_back(static_cast<BodyId>(id));
  }
}

BodyOnEdge& EdgeProver::carried_in(std::size_t carried, Index frame) {
  auto& body = frames_[at(frame + 1)][carried];
  if (!body) body = std::make_unique<BodyOnEdge>(bodies_[at(tree_.bodies[carried])]->shape(), false);
  return *body;
}

void EdgeProver::begin(std::span<const double> start, std::span<const double> end) {
  links_.begin(start, end);
  for (std::size_t frame = 0; frame < frames_.size(); ++frame)
    for (std::size_t i = 0; i < frames_[frame].size(); ++i)
      if (BodyOnEdge* body = frames_[frame][i].get())
        body->begin(links_.bend_of(tree_.carried[i], static_cast<Index>(frame) - 1, body->shape().radius));
}

BodyOnEdge& EdgeProver::body_of(const Pair& pair, bool is_second) {
  if (!is_second) return *frames_[at(pair.frame + 1)][pair.carried];
  const Index carried = carried_of_[at(pair.other)];
  return carried < 0 ? *others_[at(pair.other)] : *frames_[at(pair.frame + 1)][at(carried)];
}

const PlaceOnEdge& EdgeProver::place_of(const Pair& pair, bool is_second, std::size_t time) {
  BodyOnEdge& body = body_of(pair, is_second);
  const Index carried = is_second ? carried_of_[at(pair.other)] : static_cast<Index>(pair.carried);
  return body.at_time(time, [&](std::size_t index) {
    return carried < 0 ? bodies_[at(pair.other)]->place_at(time_of(index))
                       : links_.place_of(tree_.carried[at(carried)], pair.frame, index);
  });
}

Box EdgeProver::hull_of(std::size_t carried) {
  const Pair of_world{carried, -1, -1, false, false, false, 0};
  const BodyOnEdge& body = carried_in(carried, -1);
  const MiddleBox box(body.shape().boxes[at(body.shape().tree.root())]);
  Box hull;
  double margin = 0;
  for (const std::size_t time : {std::size_t{0}, kTimes - 1}) {
    const PlaceOnEdge& place = place_of(of_world, false, time);
    Box here;
    here.include(place.place.of(box.middle));
    Point half;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& row = place.place.rows[k];
      half[k] = std::fabs(row[0]) * box.half[0] + std::fabs(row[1]) * box.half[1] + std::fabs(row[2]) * box.half[2];
      here.low[k] -= half[k];
      here.high[k] += half[k];
    }
    hull.include(here);
    margin = std::max(margin, place.margin);
  }
  const double share = separation_ + bodies_[at(tree_.bodies[carried])]->radius();
  hull.widen((margin + body.bend().deviation(body.shape().radius, 0) + share) * kRoundedUp);
  return hull;
}

void EdgeProver::add_pair(std::size_t carried, BodyId other, Index frame) {
  if (may_meet_[carried][at(other)]) pairs_.push_back({carried, other, frame, false, false, false, 0});
}

/// The outermost links last: those that reach far collide most.
void EdgeProver::find_pairs() {
  pairs_.clear();
  for (std::size_t i = tree_.bodies.size(); i-- > 0;) {
    if (!bodies_[at(tree_.bodies[i])]->is_enabled) continue;
    const Box hull = hull_of(i);
    still_.for_each_near(hull, [&](BodyId other) { add_pair(i, other, -1); });
    for (const BodyId other : moving_) {
      Box wide = bodies_[at(other)]->hull();
      wide.widen(bodies_[at(other)]->radius() * kRoundedUp);
      if (may_meet(wide, hull)) add_pair(i, other, -1);
    }
    for (std::size_t k = 0; k < i; ++k) {
      const Index frame = common_[i][k];
      for (const std::size_t each : {i, k})
        if (!frames_[at(frame + 1)][each]) {
          BodyOnEdge& body = carried_in(each, frame);
          body.begin(links_.bend_of(tree_.carried[each], frame, body.shape().radius));
        }
      add_pair(i, tree_.bodies[k], frame);
    }
  }
}

EdgeProver::Piece EdgeProver::piece_of(const Task& task, int level) {
  const Pair& pair = pairs_[task.pair];
  Piece piece{&body_of(pair, false), &body_of(pair, true), {}, {}, {}, 0, level, 0};
  const std::size_t half = std::size_t{1} << (kFinest - level - 1);
  piece.middle = (2 * task.piece + 1) * half;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t time = (2 * task.piece + i) * half;
    piece.at_a[i] = &place_of(pair, false, time);
    piece.at_b[i] = &place_of(pair, true, time);
    piece.margin[i] = piece.at_a[i]->margin + piece.at_b[i]->margin;
  }
  piece.separation =
      separation_ + bodies_[at(tree_.bodies[pair.carried])]->radius() + bodies_[at(pair.other)]->radius();
  return piece;
}

const ProvenEdge& EdgeProver::run(std::span<const double> start, std::span<const double> end, bool ends_at_collision,
                                  const Options& options) {
  stop_if_cancelled(options);
  ends_at_collision_ = ends_at_collision;
  first_collision_ = kTimes;
  found_.collides = false;
  found_.open.clear();
  found_.at_start.clear();
  for (std::size_t i = 0; i < tree_.bodies.size(); ++i) carried_in(i, -1);
  begin(start, end);
  find_pairs();
  front_.clear();
  tasks_.clear();
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const Index a = body_of(pairs_[i], false).shape().tree.root(), b = body_of(pairs_[i], true).shape().tree.root();
    tasks_.push_back({i, 0, front_.size(), front_.size() + 1});
    front_.push_back({a, b});
  }
  for (int level = 0; level <= kLastLevel && !tasks_.empty(); ++level) {
    stop_if_cancelled(options);
    next_.clear();
    later_.clear();
    for (const Task& task : tasks_) {
      prove(task, level);
      if (found_.collides) return found_;
    }
    front_.swap(next_);
    tasks_.swap(later_);
  }
  for (const auto& [pair, piece, first, last] : tasks_)
    if ((piece << (kFinest - kLastLevel - 1)) < first_collision_) pairs_[pair].is_open = true;
  conclude();
  return found_;
}

void EdgeProver::prove(const Task& task, int level) {
  now_ = &pairs_[task.pair];
  if (now_->is_open || (task.piece << (kFinest - level)) >= first_collision_) return;
  const Piece piece = piece_of(task, level);
  const std::size_t first = next_.size();
  const Item root = front_[task.first];
  for (std::size_t i = task.first; i < task.last && !now_->is_open; ++i) {
    stack_.assign(1, front_[i]);
    while (!stack_.empty() && !found_.collides && !now_->is_open) {
      const Item item = stack_.back();
      stack_.pop_back();
      visit(piece, item);
    }
    if (found_.collides) return;
  }
  if (now_->visits > kMostVisits) now_->is_open = true;
  if (now_->is_open) {  // it may also be since it surely collides
    next_.resize(first);
  } else if (next_.size() == first) {
    const bool is_root =
        task.last == task.first + 1 && root.a == piece.a->shape().tree.root() && root.b == piece.b->shape().tree.root();
    if (task.piece == 0 && is_root && !now_->is_near) now_->is_apart_at_start = true;
  } else {
    for (const std::size_t half : {0, 1}) later_.push_back({task.pair, 2 * task.piece + half, first, next_.size()});
  }
}

void EdgeProver::visit(const Piece& piece, const Item& item) {
  ++now_->visits;
  if (item.a < 0) return visit_items(piece, item);
  const BodyShape &shape_a = piece.a->shape(), &shape_b = piece.b->shape();
  const MiddleBox a(shape_a.boxes[at(item.a)]), b(shape_b.boxes[at(item.b)]);
  const double deviation = piece.deviation(a.reach, b.reach);
  std::array<Point, 3> way;
  for (std::size_t i = 0; i < 3; ++i)
    way[i] = difference(piece.at_b[i]->place.of(b.middle), piece.at_a[i]->place.of(a.middle));
  // Balls around the boxes.
  const double balls = (a.radius + b.radius) * kRoundedUp, length = std::sqrt(dot_of(way[1], way[1]));
  if (length > balls + piece.separation) {
    const Point direction{way[1][0] / length, way[1][1] / length, way[1][2] / length};
    if (piece.proves(dot_of(direction, way[0]) - balls, dot_of(direction, way[2]) - balls, deviation)) return;
  }
  const Gap gap = gap_of(a, piece.at_a[1]->place, b, piece.at_b[1]->place);
  const Point moved = difference(way[2], way[0]);
  double loss = std::sqrt(dot_of(moved, moved)) + deviation;
  if (gap.width > piece.separation) {
    std::array<double, 3> width{};
    for (const std::size_t i : {0, 2})
      width[i] = dot_of(gap.direction, way[i]) - a.extent(piece.at_a[i]->place, gap.direction) -
                 b.extent(piece.at_b[i]->place, gap.direction);
    if (piece.proves(width[0], width[2], deviation)) return;
    loss = gap.width - std::min(width[0], width[2]) + deviation;
  }
  now_->is_near = true;  // from here on not by whole bodies
  // Where most is lost by the motion, a shorter piece proves more than smaller boxes.
  constexpr double kLargeLoss = 0.25, kLargeLossOfLeaves = 0.1;  // leaves have up to 256 pairs of items
  const bool are_leaves = shape_a.tree.is_leaf(item.a) && shape_b.tree.is_leaf(item.b);
  if (loss > (are_leaves ? kLargeLossOfLeaves : kLargeLoss) * std::max(a.radius, b.radius)) {
    next_.push_back(item);
    if (gap.width <= 0) probe(piece, item);
  } else if (are_leaves) {
    visit_leaves(piece, item);
  } else {
    for_each_part(piece, item, a.radius >= b.radius, [&](const Item& part) { stack_.push_back(part); });
  }
}

/// Replaces the larger node by its children.
template <class F>
void EdgeProver::for_each_part(const Piece& piece, const Item& item, bool is_a_larger, const F& f) {
  const BoxTree &tree_a = piece.a->shape().tree, &tree_b = piece.b->shape().tree;
  if (tree_b.is_leaf(item.b) || (!tree_a.is_leaf(item.a) && is_a_larger))
    tree_a.for_each_child(item.a, [&](Index child) { f(Item{child, item.b}); });
  else
    tree_b.for_each_child(item.b, [&](Index child) { f(Item{item.a, child}); });
}

/// Looks for triangles of both nodes that surely pass through each other in the middle of the piece.
void EdgeProver::probe(const Piece& piece, const Item& item) {
  if (found_.collides || now_->is_open) return;
  ++now_->visits;
  const BodyShape &shape_a = piece.a->shape(), &shape_b = piece.b->shape();
  if (shape_a.tree.is_leaf(item.a) && shape_b.tree.is_leaf(item.b)) return probe_leaves(piece, item);
  const double half_a = shape_a.boxes[at(item.a)].extent(), half_b = shape_b.boxes[at(item.b)].extent();
  for_each_part(piece, item, half_a >= half_b, [&](const Item& part) {
    const MiddleBox a(shape_a.boxes[at(part.a)]), b(shape_b.boxes[at(part.b)]);
    if (gap_of(a, piece.at_a[1]->place, b, piece.at_b[1]->place).width <= 0) probe(piece, part);
  });
}

void EdgeProver::probe_leaves(const Piece& piece, const Item& leaves) {
  const auto items_a = piece.a->shape().tree.items_of(leaves.a), items_b = piece.b->shape().tree.items_of(leaves.b);
  std::array<Triangle, kBlock> of_b;
  std::array<Box, kBlock> box_b;
  Box all_b;
  for (std::size_t k = 0; k < items_b.size(); ++k) {
    of_b[k] = corners_at(*piece.b, *piece.at_b[1], items_b[k]);
    for (const Point& corner : of_b[k]) box_b[k].include(corner);
    all_b.include(box_b[k]);
  }
  for (const Index item : items_a) {
    const Triangle a = corners_at(*piece.a, *piece.at_a[1], item);
    Box box;
    for (const Point& corner : a) box.include(corner);
    if (!may_meet(box, all_b)) continue;
    for (std::size_t k = 0; k < items_b.size(); ++k)
      if (may_meet(box, box_b[k]) && surely_meet(a, of_b[k], piece.margin[1])) return collide(piece);
  }
}

void EdgeProver::collide(const Piece& piece) {
  (ends_at_collision_ ? found_.collides : now_->is_open) = true;
  first_collision_ = std::min(first_collision_, piece.middle);
}

Triangle EdgeProver::corners_at(const BodyOnEdge& body, const PlaceOnEdge& place, Index item) {
  const Face corners = body.shape().corners_of(item);
  Triangle found;
  for (std::size_t k = 0; k < 3; ++k) found[k] = place.place.of(body.shape().points[at(corners[k])]);
  return found;
}

/// The hulls of the items on the piece are compared, axis by axis.
void EdgeProver::visit_leaves(const Piece& piece, const Item& leaves) {
  const auto hull_of = [](const BodyOnEdge& body, const std::array<const PlaceOnEdge*, 3>& places, Index item) {
    Box hull;
    for (const std::size_t i : {0, 2})
      for (const Point& corner : corners_at(body, *places[i], item)) hull.include(corner);
    return hull;
  };
  const auto items_a = piece.a->shape().tree.items_of(leaves.a), items_b = piece.b->shape().tree.items_of(leaves.b);
  const double reach_a = MiddleBox(piece.a->shape().boxes[at(leaves.a)]).reach;
  const double reach_b = MiddleBox(piece.b->shape().boxes[at(leaves.b)]).reach;
  const double deviation = piece.deviation(reach_a, reach_b);
  const double wider = (piece.separation + deviation + std::max(piece.margin[0], piece.margin[2])) * kRoundedUp;
  std::array<Box, kBlock> hull_b;
  Box all_b;
  for (std::size_t k = 0; k < items_b.size(); ++k) {
    hull_b[k] = hull_of(*piece.b, piece.at_b, items_b[k]);
    all_b.include(hull_b[k]);
  }
  for (const Index item : items_a) {
    Box hull = hull_of(*piece.a, piece.at_a, item);
    hull.widen(wider);
    if (!may_meet(hull, all_b)) continue;
    for (std::size_t k = 0; k < items_b.size(); ++k)
      if (may_meet(hull, hull_b[k])) stack_.push_back({-1 - item, -1 - items_b[k]});
  }
}

void EdgeProver::visit_items(const Piece& piece, const Item& items) {
  const Index item_a = -1 - items.a, item_b = -1 - items.b;
  const auto corners = [&](std::size_t i) {
    return std::pair(corners_at(*piece.a, *piece.at_a[i], item_a), corners_at(*piece.b, *piece.at_b[i], item_b));
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

void EdgeProver::conclude() {
  for (const Pair& pair : pairs_) {
    const BodyId body = tree_.bodies[pair.carried];
    const BodyPair named{std::min(body, pair.other), std::max(body, pair.other)};
    if (pair.is_open)
      found_.open.push_back(named);
    else if (!pair.is_apart_at_start)
      found_.at_start.push_back(named);
  }
  std::ranges::sort(found_.open);
  std::ranges::sort(found_.at_start);
}

}  // namespace tamis

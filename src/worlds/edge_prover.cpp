#include "worlds/edge_prover.hpp"

#include <algorithm>
#include <cmath>

#include "search/query/cancellation.hpp"
#include "search/topology/at.hpp"

namespace tamis {
namespace {

constexpr int kLastLevel = kFinest - 1;
/// Visits of one pair on one edge, after which a detector decides it.
constexpr int kMostVisits = 1 << 15;

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
  stays_ = std::ranges::equal(start, end);
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
  const MiddleBox& box = body.box(body.shape().tree.root());
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
  const std::size_t half = std::size_t{1} << (kFinest - level - 1), first = 2 * task.piece * half;
  return piece_at(pairs_[task.pair], {first, first + half, first + 2 * half}, level);
}

EdgeProver::Piece EdgeProver::piece_at(const Pair& pair, const std::array<std::size_t, 3>& times, int level) {
  Piece piece{&body_of(pair, false), &body_of(pair, true), {}, {}, {}, 0, level, times};
  for (std::size_t i = 0; i < 3; ++i) {
    piece.at_a[i] = &place_of(pair, false, times[i]);
    piece.at_b[i] = &place_of(pair, true, times[i]);
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
  if (ends_at_collision && collides_somewhere()) return found_;
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
    for (const std::size_t half : {std::size_t{0}, std::size_t{1}})
      later_.push_back({task.pair, 2 * task.piece + half, first, next_.size()});
  }
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

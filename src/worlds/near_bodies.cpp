#include "worlds/near_bodies.hpp"

#include <algorithm>

#include "search/query/cancellation.hpp"
#include "worlds/world_state.hpp"

namespace tamis {

double NearDistance::share_of(const Body& body) const {
  const bool counts = displacement_factor > 0 && body.motion_kind() != MotionKind::still;
  return body.radius() + (counts ? displacement_factor * body.hull().extent() : 0);
}

BodyTree::BodyTree(const BodyList& bodies, bool are_still, const NearDistance& distance) {
  std::vector<Point> centers;
  centers.reserve(bodies.size());
  bodies_.reserve(bodies.size());
  hulls_.reserve(bodies.size());
  for (std::size_t id = 0; id < bodies.size(); ++id) {
    const Body* body = bodies[id].get();
    if (!body || !body->is_enabled || (body->motion_kind() == MotionKind::still) != are_still) continue;
    bodies_.push_back(static_cast<BodyId>(id));
    Box& hull = hulls_.emplace_back(distance.is_at_start ? body->start_hull() : body->hull());
    hull.widen(distance.share_of(*body) * kRoundedUp);
    centers.push_back(hull.middle());
  }
  tree_ = BoxTree(centers);
  boxes_ = tree_.boxes([this](Index i) -> const Box& { return hulls_[at(i)]; });
}

std::vector<BodyPair> World::State::near_bodies(const NearDistance& distance) {
  stop_if_cancelled(options);
  if (only_pairs) return *only_pairs;
  if (!still_) still_.emplace(bodies, true, distance);
  const BodyTree moving(bodies, false, distance);
  std::vector<BodyPair> pairs;
  const auto add_pairs = [&](const BodyTree& tree, const BodyTree& others) {
    for (std::size_t i = 0; i < tree.bodies().size(); ++i) {
      const BodyId body = tree.bodies()[i];
      Box box = tree.hull(i);
      box.widen((distance.separation + distance.margin) * kRoundedUp);
      others.for_each_near(box, [&](BodyId other) {
        if (&tree != &others || body < other) pairs.push_back({std::min(body, other), std::max(body, other)});
      });
    }
  };
  add_pairs(moving, moving);
  add_pairs(moving, *still_);
  if (distance.include_static) add_pairs(*still_, *still_);
  std::erase_if(pairs, [&](const BodyPair& pair) { return excluded_pairs.contains(pair); });
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace tamis

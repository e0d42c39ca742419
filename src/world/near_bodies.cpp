#include "world/near_bodies.hpp"

#include "kernels/kernels.hpp"

namespace tamis {
namespace {

template <class F>
BodyTree tree_of(const BodyList& bodies, const ReachOfBody& own, bool at_start, Split split, const F& is_wanted) {
  std::vector<BodyId> ids;
  std::vector<Box> hulls;
  for (std::size_t id = 0; id < bodies.size(); ++id) {
    const Body* body = bodies[id].get();
    if (!body || !body->is_enabled || !is_wanted(*body)) continue;
    ids.push_back(static_cast<BodyId>(id));
    hulls.push_back(at_start ? body->start_hull() : body->hull());
    hulls.back().widen(own(*body));
  }
  return {std::move(ids), std::move(hulls), split};
}

}  // namespace

BodyTree::BodyTree(std::vector<BodyId> bodies, std::vector<Box> hulls, Split split)
    : bodies_(std::move(bodies)), hulls_(std::move(hulls)) {
  std::vector<Point> centers;
  centers.reserve(hulls_.size());
  for (const Box& hull : hulls_) centers.push_back(hull.middle());
  order_ = SpaceOrder(centers, split);
  levels_ = BoxLevels(order_, [this](Index i) -> const Box& { return hulls_[static_cast<std::size_t>(i)]; });
}

NearBodies::NearBodies(Isa isa) : split_(kernels(isa).trees.split) {}

std::vector<BodyPair> NearBodies::find(const BodyList& bodies, const ReachOfBody& own, double separation,
                                       bool at_start) {
  const auto is_still = [](const Body& body) { return body.motion_kind() == MotionKind::still; };
  if (!knows_still_) still_ = tree_of(bodies, own, false, split_, is_still);
  knows_still_ = true;
  const BodyTree moving = tree_of(bodies, own, at_start, split_, [&](const Body& body) { return !is_still(body); });
  std::vector<BodyPair> pairs;
  for (std::size_t i = 0; i < moving.bodies().size(); ++i) {
    const BodyId body = moving.bodies()[i];
    Box box = moving.hull(i);
    box.widen(separation);
    moving.for_each_near(box, [&](BodyId other) {
      if (body < other) pairs.push_back({body, other});
    });
    still_.for_each_near(box, [&](BodyId other) { pairs.push_back({std::min(body, other), std::max(body, other)}); });
  }
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace tamis

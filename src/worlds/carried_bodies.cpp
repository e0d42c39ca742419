#include "worlds/carried_bodies.hpp"

#include <algorithm>
#include <map>

#include "search/topology/at.hpp"

namespace tamis {
namespace {

/// Any order that makes equal links neighbours; 0 and -0 are equal.
bool is_pose_before(const Pose& a, const Pose& b) {
  return a.position != b.position ? a.position < b.position : a.rotation < b.rotation;
}
struct ByNumbers {
  bool operator()(const RigidLink& a, const RigidLink& b) const {
    return a.start == b.start ? is_pose_before(a.end, b.end) : is_pose_before(a.start, b.start);
  }
  bool operator()(const RigidChain& a, const RigidChain& b) const {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), *this);
  }
};

/// True if the body has a link that may be shared.
bool is_carried(const Body& body) { return body.motion_kind() == MotionKind::turning && !body.chain().empty(); }

}  // namespace

bool turn_together(const Body& a, const Body& b) {
  return is_carried(a) && is_carried(b) && a.chain().front() == b.chain().front();
}

std::vector<CarriedPairs> carried_pairs(const BodyList& bodies, const std::vector<BodyPair>& pairs) {
  std::map<RigidChain, std::vector<BodyPair>, ByNumbers> of_carrier;
  for (const BodyPair& pair : pairs) {
    const Body &a = *bodies[at(pair[0])], &b = *bodies[at(pair[1])];
    if (!turn_together(a, b)) continue;
    const auto count = static_cast<std::ptrdiff_t>(shared_links(a.chain(), b.chain()));
    of_carrier[RigidChain(a.chain().begin(), a.chain().begin() + count)].push_back(pair);
  }
  std::vector<CarriedPairs> all;
  for (auto& [carrier, carried] : of_carrier) all.push_back({carrier, std::move(carried)});
  return all;
}

BodyList CarriedPairs::in_frame(const BodyList& bodies, const std::vector<BodyId>& others) const {
  BodyList seen(bodies.size());
  const auto see = [&](BodyId id) {
    if (!seen[at(id)]) seen[at(id)] = std::make_unique<Body>(*bodies[at(id)], carrier.size());
  };
  for (const BodyPair& pair : pairs) std::ranges::for_each(pair, see);
  for (const BodyId id : others) {
    const Body* body = bodies[at(id)].get();
    if (body && is_carried(*body) && shared_links(carrier, body->chain()) == carrier.size()) see(id);
  }
  return seen;
}

std::vector<BodyId> first_of_carrier(const BodyList& bodies, const std::vector<BodyId>& ids) {
  std::map<RigidLink, BodyId, ByNumbers> first;
  std::vector<BodyId> found;
  for (const BodyId id : ids) {
    const Body& body = *bodies[at(id)];
    found.push_back(is_carried(body) ? first.try_emplace(body.chain().front(), id).first->second : id);
  }
  return found;
}

}  // namespace tamis

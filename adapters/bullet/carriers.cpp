#include "adapters/bullet/carriers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace tamis::bullet {
namespace {

/// Rounds over the contacts of one body with its carriers, which are few; the clamp holds back what these rounds leave.
constexpr int kRounds = 20;
/// In gaps a step: rounds that change no speed by more than this are the last ones.
constexpr btScalar kSettled = 1e-6F;
/// The part of a missing gap that one step restores. As in solvers a gap is restored over some steps, so that a body is
/// not pushed into what lies on it.
constexpr btScalar kParted = 0.5F;

}  // namespace

Carriers::Answer::Answer(const NearSide& side, const btVector3& way)
    : body(btRigidBody::upcast(side.object)), direction(way) {
  if (!body) return;
  const btVector3 arm = side.point() - body->getWorldTransform().getOrigin();
  about = arm.cross(direction);
  linear = direction * body->getLinearFactor() * body->getInvMass();
  angular =
      body->getInvInertiaTensorWorld() * arm.cross(direction * body->getLinearFactor()) * body->getAngularFactor();
}

btScalar Carriers::Answer::speed() const {
  return body ? body->getLinearVelocity().dot(direction) + body->getAngularVelocity().dot(about) : btScalar(0);
}

void Carriers::Answer::push(btScalar impulse) const {
  body->setLinearVelocity(body->getLinearVelocity() + linear * impulse);
  body->setAngularVelocity(body->getAngularVelocity() + angular * impulse);
}

btScalar Carriers::Contact::push() {
  if (!(give > 0)) return 0;  // a body on an axle
  const btScalar before = impulse;
  const btScalar speed = body.speed() - other.speed();
  impulse = std::max(btScalar(0), before - (speed + allowed + softness * before) / (give + softness));
  body.push(impulse - before);
  if (other_gives) other.push(before - impulse);
  return std::abs(impulse - before) * give;
}

Carriers::Carriers(std::span<const NearContact> near, btScalar gap, btScalar seconds) : gap_(gap), seconds_(seconds) {
  std::unordered_map<const btCollisionObject*, std::size_t> known;
  for (const NearContact& contact : near) {
    std::array<std::size_t, 2> at{};
    for (const std::size_t i : {0U, 1U}) {
      const auto [place, is_new] = known.try_emplace(contact.sides[i].object, bodies_.size());
      if (is_new) bodies_.push_back({contact.sides[i].object, {}});
      at[i] = place->second;
    }
    for (const std::size_t i : {0U, 1U}) bodies_[at[i]].contacts.push_back({&contact, i, at[1 - i]});
  }
  find_levels();
  for (const std::size_t i : order_) keep_carriers(bodies_[i]);
}

void Carriers::keep_carriers(Body& body) {
  std::erase_if(body.contacts, [&](const Contact& contact) { return bodies_[contact.other_at].level >= body.level; });
  for (Contact& contact : body.contacts) {
    const NearContact& near = *contact.near;
    const btVector3 up = contact.side == 0 ? near.normal : -near.normal;
    contact.body = Answer(near.sides[contact.side], up);
    contact.other = Answer(near.sides[1 - contact.side], up);
    contact.above_gap = near.distance() - gap_;
    contact.give = contact.body.give() + (contact.other_gives ? contact.other.give() : btScalar(0));
  }
}

/// Breadth first, from the objects that stand; then, in each group without one, from its heaviest body.
void Carriers::find_levels() {
  std::vector<std::size_t> roots(bodies_.size());
  for (std::size_t i = 0; i < roots.size(); ++i) roots[i] = i;
  const auto give = [&](std::size_t i) {
    const btCollisionObject& object = *bodies_[i].object;
    return moves(object) ? btRigidBody::upcast(&object)->getInvMass() : btScalar(-1);
  };
  std::ranges::stable_sort(roots, {}, give);
  for (auto root = roots.begin(); root != roots.end(); ++root) {
    if (bodies_[*root].level >= 0) continue;
    const bool nothing_stands = give(*root) >= 0;
    std::vector<std::size_t> reached;
    const auto reach = [&](std::size_t i, int level) {
      if (bodies_[i].level >= 0) return;
      bodies_[i].level = level;
      reached.push_back(i);
    };
    reach(*root, 0);
    // All standing objects, the first of `roots`, are reached at once: a body's level counts from the nearest of them.
    for (auto next = root + 1; next != roots.end() && give(*next) < 0; ++next) reach(*next, 0);
    for (std::size_t next = 0; next < reached.size(); ++next) {
      const std::size_t i = reached[next];
      if (bodies_[i].level > 0) order_.push_back(i);
      for (Contact& contact : bodies_[i].contacts) {
        contact.other_gives = nothing_stands && btRigidBody::upcast(bodies_[contact.other_at].object);
        reach(contact.other_at, bodies_[i].level + 1);
      }
    }
  }
}

template <class Allowed>
void Carriers::push(const Allowed& allowed, bool is_soft) {
  for (const std::size_t i : order_) {
    std::vector<Contact>& contacts = bodies_[i].contacts;
    for (Contact& contact : contacts) {
      contact.impulse = 0;
      contact.softness = is_soft && contact.above_gap < 0 ? contact.give : 0;
      contact.allowed = allowed(contact.above_gap) / seconds_;
    }
    const btScalar settled = kSettled * gap_ / seconds_;
    btScalar change = 2 * settled;
    for (int round = 0; round < kRounds && change > settled; ++round) {
      change = 0;
      for (Contact& contact : contacts) change = std::max(change, contact.push());
    }
  }
}

void Carriers::take_speed() {
  push([](btScalar above_gap) { return std::max(btScalar(0), above_gap); }, false);
}

void Carriers::part(const std::function<void()>& go) {
  struct Speed {
    btVector3 linear, turn;
  };
  std::vector<Speed> speeds;
  for (const std::size_t i : order_) {
    const btRigidBody& body = *btRigidBody::upcast(bodies_[i].object);
    speeds.push_back({body.getLinearVelocity(), body.getAngularVelocity()});
  }
  push([](btScalar above_gap) { return above_gap < 0 ? above_gap * kParted : above_gap; }, true);
  go();
  for (std::size_t k = 0; k < order_.size(); ++k) {
    btRigidBody& body = *btRigidBody::upcast(bodies_[order_[k]].object);
    body.setLinearVelocity(speeds[k].linear);
    body.setAngularVelocity(speeds[k].turn);
  }
}

}  // namespace tamis::bullet

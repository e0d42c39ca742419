#include "adapters/bullet/carriers.hpp"

#include <algorithm>
#include <map>

namespace tamis::bullet {
namespace {

/// Rounds over the contacts of one body with its carriers, which are few; the clamp holds back what these rounds leave.
constexpr int kRounds = 20;
/// The part of a missing gap that one step restores. As in solvers a gap is restored over some steps, so that a body is
/// not pushed into what lies on it.
constexpr btScalar kParted = 0.5F;

/// The speed along `up` that an impulse of 1 along it gives to the body at `arm` from its origin.
btScalar give_of(const btRigidBody& body, const btVector3& arm, const btVector3& up) {
  return body.getInvMass() + (body.getInvInertiaTensorWorld() * arm.cross(up)).cross(arm).dot(up);
}

}  // namespace

void Carriers::Contact::push() {
  btVector3 speed = body->getVelocityInLocalPoint(arm);
  if (other) speed -= other->getVelocityInLocalPoint(other_arm);
  if (!(give > 0)) return;  // a body on an axle
  const btScalar before = impulse;
  impulse = std::max(btScalar(0), before - (speed.dot(up) + allowed + softness * before) / (give + softness));
  body->applyImpulse(up * (impulse - before), arm);
  if (other_gives) other->applyImpulse(up * (before - impulse), other_arm);
}

Carriers::Carriers(std::span<const NearContact> near, btScalar gap, btScalar seconds) : seconds_(seconds) {
  std::map<const btCollisionObject*, std::size_t> known;
  for (const NearContact& contact : near)
    for (const NearSide& side : contact.sides)
      if (known.try_emplace(side.object, bodies_.size()).second) bodies_.push_back({side.object, {}});
  for (const NearContact& contact : near)
    for (const std::size_t i : {0U, 1U}) {
      const NearSide &above = contact.sides[i], &below = contact.sides[1 - i];
      bodies_[known.at(above.object)].contacts.push_back(
          {btRigidBody::upcast(above.object), btRigidBody::upcast(below.object), known.at(below.object),
           above.point() - above.object->getWorldTransform().getOrigin(),
           below.point() - below.object->getWorldTransform().getOrigin(), i == 0 ? contact.normal : -contact.normal,
           contact.distance() - gap});
    }
  find_levels();
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
        contact.other_gives = nothing_stands && contact.other;
        reach(contact.other_at, bodies_[i].level + 1);
      }
    }
  }
}

template <class Allowed>
void Carriers::push(const Allowed& allowed, bool is_soft) {
  for (const std::size_t i : order_) {
    std::vector<Contact*> below;
    for (Contact& contact : bodies_[i].contacts) {
      contact.impulse = 0;
      contact.give = give_of(*contact.body, contact.arm, contact.up);
      if (contact.other_gives) contact.give += give_of(*contact.other, contact.other_arm, contact.up);
      contact.softness = is_soft && contact.above_gap < 0 ? contact.give : 0;
      contact.allowed = allowed(contact.above_gap) / seconds_;
      if (bodies_[contact.other_at].level < bodies_[i].level) below.push_back(&contact);
    }
    for (int round = 0; round < kRounds; ++round)
      for (Contact* const contact : below) contact->push();
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

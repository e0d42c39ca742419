#include "integrations/bullet/clamped_world.hpp"

#include <LinearMath/btTransformUtil.h>

#include <algorithm>
#include <set>
#include <utility>

#include "integrations/bullet/mesh_of_shape.hpp"

namespace tamis::bullet {
namespace {

/// In gaps: by so much more are bodies that overlap to be parted, so that they are clear of each other after it.
constexpr btScalar kPartedFurther = 2;

/// Bullet's motion states interpolate back from the end of a step by these velocities. They must be those of the proven
/// way, not those with which a body that was held back wants to go on.
void show_way(btRigidBody& body, const btTransform& start, const btTransform& end, btScalar seconds) {
  btVector3 speed, turning;
  btTransformUtil::calculateVelocity(start, end, seconds, speed, turning);
  body.setInterpolationLinearVelocity(speed);
  body.setInterpolationAngularVelocity(turning);
}

}  // namespace

/// The way of a body in one step; `at` returns places on it. It begins where the last step ended: Bullet's solver may
/// have moved the body since, out of a margin that it was deep in (split impulse), and that is part of the way.
class ClampedWorld::Way {
 public:
  Way(const btTransform& start, const btTransform& end) : start_(start), end_(end) {
    btVector3 axis;
    btScalar angle;
    btTransformUtil::calculateDiffAxisAngle(start_, end_, axis, angle);
    turn_ = axis * angle;
  }

  btTransform at(double fraction) const {
    if (fraction <= 0) return start_;
    if (fraction >= 1) return end_;
    btTransform place;
    btTransformUtil::integrateTransform(start_, end_.getOrigin() - start_.getOrigin(), turn_,
                                        static_cast<btScalar>(fraction), place);
    return place;
  }

 private:
  btTransform start_, end_;
  btVector3 turn_;
};

namespace {

adapters::Velocity velocity_of(const btRigidBody& body) {
  return {point_of(body.getLinearVelocity()), point_of(body.getAngularVelocity())};
}

adapters::Inertia inertia_of(const btRigidBody& body) {
  adapters::Inertia inertia{point_of(body.getLinearFactor() * body.getInvMass()), {}};
  for (int i = 0; i < 3; ++i)
    inertia.inverse_inertia[static_cast<std::size_t>(i)] =
        point_of(body.getAngularFactor()[i] * body.getInvInertiaTensorWorld()[i]);
  return inertia;
}

}  // namespace

class ClampedWorld::Step final : public adapters::WantedStep {
 public:
  explicit Step(const ClampedWorld& world) : world_(world) {}

  /// After the solver: the bodies that move, with the ways that it gives them.
  void begin_ways(btScalar seconds) {
    seconds_ = seconds;
    const btAlignedObjectArray<btRigidBody*>& all = world_.getNonStaticRigidBodies();  // not static when added
    std::set<const btCollisionObject*> may_move;
    for (int i = 0; i < all.size(); ++i) may_move.insert(all[i]);
    for (const auto& [id, member] : world_.members_) {
      if (!may_move.contains(member.object) || !moves(*member.object)) continue;
      btTransform end;
      btRigidBody::upcast(member.object)->predictIntegratedTransform(seconds, end);
      ways_.emplace(id, Way(member.place, end));
      moving_.push_back(id);
    }
  }
  btTransform place(BodyId body, double fraction) const { return ways_.at(body).at(fraction); }

  const Shape& shape(BodyId body) const override { return member(body).shape.surface->mesh; }
  bool collides(const adapters::BodyPair& bodies) const override {
    btCollisionObject *const a = member(bodies[0]).object, *const b = member(bodies[1]).object;
    const btOverlappingPairCache& pairs = *world_.getBroadphase()->getOverlappingPairCache();
    const bool do_collide = pairs.needsBroadphaseCollision(a->getBroadphaseHandle(), b->getBroadphaseHandle()) &&
                            world_.m_dispatcher1->needsCollision(a, b) && a->hasContactResponse() &&
                            b->hasContactResponse();
    all_collide_ = all_collide_ && do_collide;
    return do_collide;
  }
  /// False if two bodies that met, or were near each other or overlapped, may pass through each other.
  bool all_collide() const { return all_collide_; }
  double seconds() const override { return double{seconds_}; }
  std::span<const BodyId> moving() const override { return moving_; }
  Pose pose(BodyId body, double fraction) const override {
    return fraction > 0 ? pose_of(place(body, fraction)) : member(body).pose;
  }
  double radius(BodyId body) const override { return member(body).shape.surface->radius; }
  adapters::Inertia inertia(BodyId body) const override { return inertia_of(*rigid(body)); }
  /// Bullet's solver rubs at the same contacts.
  double friction(const adapters::BodyPair& /*bodies*/) const override { return 0; }
  adapters::Velocity velocity(BodyId body) const override {
    return rigid(body) ? velocity_of(*rigid(body)) : adapters::Velocity{};
  }
  /// Where the solver has moved the body since the last step, out of a margin, that is part of its way.
  adapters::Velocity way(BodyId body) const override {
    if (member(body).place == member(body).object->getWorldTransform()) return velocity(body);
    btVector3 linear, angular;
    btTransformUtil::calculateVelocity(member(body).place, place(body, 1), seconds_, linear, angular);
    return {point_of(linear), point_of(angular)};
  }
  void set_way(BodyId body, const adapters::Velocity& way) override {
    btTransform end;
    btTransformUtil::integrateTransform(member(body).place, vector_of(way.linear), vector_of(way.angular), seconds_,
                                        end);
    ways_.at(body) = Way(member(body).place, end);
  }

 private:
  const Member& member(BodyId body) const { return world_.members_.at(body); }
  btRigidBody* rigid(BodyId body) const { return btRigidBody::upcast(member(body).object); }

  const ClampedWorld& world_;
  mutable bool all_collide_ = true;
  btScalar seconds_ = 0;
  std::vector<BodyId> moving_;
  std::map<BodyId, Way> ways_;
};

ClampedWorld::ClampedWorld(btDispatcher* dispatcher, btBroadphaseInterface* broadphase, btConstraintSolver* solver,
                           btCollisionConfiguration* configuration, adapters::ClampOptions options, int threads)
    : btDiscreteDynamicsWorld(dispatcher, broadphase, solver, configuration),
      options_(options),
      bodies_(Options{.threads = threads}) {
  adapters::validate(options);
}

void ClampedWorld::createPredictiveContacts(btScalar seconds) {
  SolverContacts for_solver(*m_dispatcher1, m_predictiveManifolds);
  btDiscreteDynamicsWorld::createPredictiveContacts(seconds);
  follow();
  const Step bodies(*this);
  beginning_ = adapters::beginning(bodies_, bodies, options_, std::exchange(are_apart_, false));
  const auto add = [&](const adapters::NearContact& contact) {
    const auto& [first, second] = contact.bodies;
    for_solver.add({members_.at(first).object, members_.at(second).object}, contact, options_.gap,
                   m_predictiveManifolds);
  };
  for (const auto& [both, near] : beginning_.near) std::ranges::for_each(near.contacts, add);
  for (const BodyContact& limit : limits_) {
    const adapters::BodyPair both = adapters::pair_of(limit.bodies);
    if (members_.contains(both[0]) && members_.contains(both[1]) && !beginning_.overlapping.contains(both) &&
        bodies.collides(both))
      add(adapters::contact_at(bodies_, bodies, limit, 0));
  }
  all_collide_ = bodies.all_collide();
  for_solver.start_warm();
}

/// Bullet parts bodies that overlap only until its margins touch, at no distance; from there they overlap again.
void ClampedWorld::performDiscreteCollisionDetection() {
  btDiscreteDynamicsWorld::performDiscreteCollisionDetection();
  std::set<std::pair<const btCollisionObject*, const btCollisionObject*>> overlapping;
  for (const auto& [a, b] : beginning_.overlapping)
    if (members_.contains(a) && members_.contains(b))  // the caller may ask between steps, after bodies were removed
      overlapping.insert(std::minmax<const btCollisionObject*>(members_.at(a).object, members_.at(b).object));
  for (int i = 0; !overlapping.empty() && i < m_dispatcher1->getNumManifolds(); ++i) {
    btPersistentManifold& manifold = *m_dispatcher1->getManifoldByIndexInternal(i);
    if (!overlapping.contains(std::minmax(manifold.getBody0(), manifold.getBody1()))) continue;
    for (int k = 0; k < manifold.getNumContacts(); ++k) {
      btManifoldPoint& point = manifold.getContactPoint(k);
      point.setDistance(point.getDistance() - kPartedFurther * static_cast<btScalar>(options_.gap));
    }
  }
}

void ClampedWorld::set_overlapping_may_touch(bool may_touch) {
  for (const auto& [a, b] : beginning_.overlapping) bodies_.set_may_touch(a, b, may_touch);
}

void ClampedWorld::integrateTransforms(btScalar seconds) {
  Step step(*this);
  step.begin_ways(seconds);
  adapters::ClampedStep clamped;
  set_overlapping_may_touch(false);
  try {
    clamped = adapters::clamp(bodies_, step, beginning_, options_);
  } catch (...) {
    set_overlapping_may_touch(true);
    throw;
  }
  set_overlapping_may_touch(true);
  limits_ = std::move(clamped.limits);
  last_step_ = {{}, clamped.questions, beginning_.overlapping.size()};
  for (std::size_t i = 0; i < clamped.ends.size(); ++i) {
    const BodyId id = step.moving()[i];
    const auto& [fraction, velocity] = clamped.ends[i];
    Member& member = members_.at(id);
    btRigidBody* const body = btRigidBody::upcast(member.object);
    body->setHitFraction(static_cast<btScalar>(fraction));
    const btTransform start = member.place, end = step.place(id, fraction);
    body->proceedToTransform(end);
    show_way(*body, start, end, seconds);
    body->setLinearVelocity(vector_of(velocity.linear));
    body->setAngularVelocity(vector_of(velocity.angular));
    put(id, member);
    last_step_.moved.emplace_back(body, fraction);
  }
  are_apart_ = beginning_.overlapping.empty() && all_collide_ && step.all_collide();
}

}  // namespace tamis::bullet

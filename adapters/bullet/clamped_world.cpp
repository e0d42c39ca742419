#include "adapters/bullet/clamped_world.hpp"

#include <LinearMath/btTransformUtil.h>

#include <algorithm>
#include <optional>
#include <set>

#include "adapters/bullet/carriers.hpp"
#include "adapters/bullet/mesh_of_shape.hpp"

namespace tamis::bullet {
namespace {

/// A body that goes less than this part of its way keeps so much of its speed: if it kept all, gravity would add to it
/// in each step, and where the solver's contacts do not part it from what it lies on it would hang there for ever.
constexpr double kStands = 1e-3;
constexpr btScalar kKeptSpeed = 0.5F;
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

class ClampedWorld::Step final : public adapters::WantedStep {
 public:
  Step(const ClampedWorld& world, btScalar seconds) : world_(world) {
    const btAlignedObjectArray<btRigidBody*>& all = world.getNonStaticRigidBodies();  // not static when added
    std::set<const btCollisionObject*> may_move;
    for (int i = 0; i < all.size(); ++i) may_move.insert(all[i]);
    for (const auto& [id, member] : world.members_) {
      if (!may_move.contains(member.object) || !moves(*member.object)) continue;
      btTransform end;
      btRigidBody::upcast(member.object)->predictIntegratedTransform(seconds, end);
      ways_.emplace(id, Way(member.place, end));
      moving_.push_back(id);
    }
  }

  std::span<const BodyId> moving() const override { return moving_; }
  Pose pose(BodyId body, double fraction) const override {
    return fraction > 0 ? pose_of(place(body, fraction)) : world_.members_.at(body).pose;
  }
  double radius(BodyId body) const override { return world_.members_.at(body).shape.surface->radius; }
  bool collides(const adapters::BodyPair& bodies) const override { return world_.collides(bodies); }

  std::vector<adapters::Approach> approaches() const override {
    std::vector<adapters::Approach> all;
    for (const auto& [bodies, near] : world_.near_) all.push_back({bodies, near.distance, {0, 0}});
    for (const auto& [bodies, near] : world_.near_)
      for (const NearContact& contact : near.contacts)
        if (contact.distance() > 0) all.push_back(approach_at(contact));
    return all;
  }

  btTransform place(BodyId body, double fraction) const { return ways_.at(body).at(fraction); }

 private:
  adapters::Approach approach_at(const NearContact& contact) const {
    adapters::Approach approach{contact.bodies, double{contact.distance()}, {0, 0}};
    for (const std::size_t k : {0U, 1U})
      if (const auto way = ways_.find(approach.bodies[k]); way != ways_.end()) {
        const btVector3& local = contact.sides[k].local;
        const btScalar parting = (way->second.at(1) * local - way->second.at(0) * local).dot(contact.normal);
        approach.closing[k] = k == 0 ? -parting : parting;
      }
    return approach;
  }

  const ClampedWorld& world_;
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

bool ClampedWorld::collides(const adapters::BodyPair& bodies) const {
  btCollisionObject *const a = members_.at(bodies[0]).object, *const b = members_.at(bodies[1]).object;
  const btOverlappingPairCache& pairs = *getBroadphase()->getOverlappingPairCache();
  return pairs.needsBroadphaseCollision(a->getBroadphaseHandle(), b->getBroadphaseHandle()) &&
         m_dispatcher1->needsCollision(a, b) && a->hasContactResponse() && b->hasContactResponse();
}

namespace {

/// Two edges that are nearest at an end of one: that vertex and the other's face or edge are a pair, too.
bool is_said_by_a_vertex(const BodyNearPair& pair) {
  const auto is_end = [](double weight) { return weight == 0 || weight == 1; };
  return pair.kind == PairKind::edge_edge && (is_end(pair.u) || is_end(pair.v));
}

/// Does another pair of the same bodies have the same nearest points? Of two vertices the first is that of the smaller
/// body.
bool is_said_by_another(const BodyNearPair& pair, const std::array<NearFeature, 2>& features) {
  return features[0].is_repeated() || features[1].is_repeated() ||
         (pair.bodies[0] > pair.bodies[1] && features[0].is_vertex() && features[1].is_vertex());
}

}  // namespace

/// Two bodies, in the order in which pairs of their features have them.
class ClampedWorld::Meeting {
 public:
  Meeting(const std::array<BodyId, 2>& bodies, const Member& first, const Member& second)
      : pair_(adapters::pair_of(bodies)), is_in_order_(pair_ == bodies), members_{&first, &second} {}

  const adapters::BodyPair& pair() const { return pair_; }
  /// Adds what the pair of features says, where the bodies are now.
  void add(const BodyNearPair& pair, NearBodies& near) const {
    if (!(pair.distance > 0)) return;
    near.distance = std::min(near.distance, pair.distance);
    if (is_said_by_a_vertex(pair)) return;
    const std::array<NearFeature, 2> features = features_of(pair);
    if (is_said_by_another(pair, features)) return;
    const btVector3 normal = vector_of(pair.direction);
    if (features[0].is_nearest(to_local(0, -normal)) && features[1].is_nearest(to_local(1, normal)))
      near.contacts.push_back(contact_at(features, normal));
  }
  NearContact contact_of(const BodyContact& contact) const {
    return contact_at(features_of(contact), vector_of(contact.normal));
  }

 private:
  /// The first one first. Keeps references.
  template <class Pair>
  std::array<NearFeature, 2> features_of(const Pair& pair) const {
    const auto all = weights_of(pair.kind, pair.u, pair.v);
    const std::span<const Index> vertices(pair.vertices);
    const std::size_t of_first = pair.kind == PairKind::edge_edge ? 2 : 1;
    std::array<std::array<double, 3>, 2> weights{};
    for (std::size_t i = 0; i < of_first; ++i) weights[0][i] = all[i];
    for (std::size_t i = of_first; i < all.size(); ++i) weights[1][i - of_first] = -all[i];
    return {NearFeature(*members_[0]->shape.surface, vertices.first(of_first), weights[0]),
            NearFeature(*members_[1]->shape.surface, vertices.subspan(of_first), weights[1])};
  }

  NearContact contact_at(const std::array<NearFeature, 2>& features, const btVector3& normal) const {
    const auto side = [&](std::size_t i) { return NearSide{members_[i]->object, features[i].point}; };
    if (is_in_order_) return {pair_, {side(0), side(1)}, normal};
    return {pair_, {side(1), side(0)}, -normal};
  }

  btVector3 to_local(std::size_t i, const btVector3& v) const { return v * members_[i]->place.getBasis(); }

  adapters::BodyPair pair_;
  bool is_in_order_;
  std::array<const Member*, 2> members_;
};

ClampedWorld::Meeting ClampedWorld::meeting_of(const std::array<BodyId, 2>& bodies) const {
  return {bodies, members_.at(bodies[0]), members_.at(bodies[1])};
}

void ClampedWorld::find_near() {
  near_.clear();
  const std::vector<BodyNearPair> pairs = bodies_.pairs_within(2 * options_.gap);
  for (auto pair = pairs.begin(); pair != pairs.end();) {
    const auto end = std::find_if(pair, pairs.end(), [&](const auto& other) { return other.bodies != pair->bodies; });
    const Meeting meeting = meeting_of(pair->bodies);
    if (!overlapping_.contains(meeting.pair()) && collides(meeting.pair())) {
      NearBodies& near = near_.try_emplace(meeting.pair(), NearBodies{2 * options_.gap, {}}).first->second;
      std::for_each(pair, end, [&](const BodyNearPair& one) { meeting.add(one, near); });
    }
    pair = end;
  }
  for (auto& [bodies, near] : near_) near.contacts = essential(near.contacts);
}

void ClampedWorld::createPredictiveContacts(btScalar seconds) {
  SolverContacts for_solver(*m_dispatcher1, m_predictiveManifolds);
  btDiscreteDynamicsWorld::createPredictiveContacts(seconds);
  follow();
  overlapping_ = adapters::overlapping(bodies_);
  find_near();
  const auto add = [&](const NearContact& contact) {
    for_solver.add(contact, static_cast<btScalar>(options_.gap), m_predictiveManifolds);
  };
  for (const auto& [bodies, near] : near_) std::ranges::for_each(near.contacts, add);
  for (const BodyContact& limit : limits_) {
    const adapters::BodyPair bodies = adapters::pair_of(limit.bodies);
    if (members_.contains(bodies[0]) && members_.contains(bodies[1]) && !overlapping_.contains(bodies) &&
        collides(bodies))
      add(meeting_of(limit.bodies).contact_of(limit));
  }
  for_solver.start_warm();
}

/// Bullet parts bodies that overlap only until its margins touch, at no distance; from there they overlap again.
void ClampedWorld::performDiscreteCollisionDetection() {
  btDiscreteDynamicsWorld::performDiscreteCollisionDetection();
  std::set<std::pair<const btCollisionObject*, const btCollisionObject*>> overlapping;
  for (const auto& [a, b] : overlapping_)
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
  for (const auto& [a, b] : overlapping_) {
    const Member& member = members_.at(a);
    if (may_touch) bodies_.move(a, adapters::resting(member.pose));  // two bodies that both stay are refused
    bodies_.set_may_touch(a, b, may_touch);
    if (may_touch) bodies_.move(a, motion_at(*member.object, member.pose));
  }
}

void ClampedWorld::integrateTransforms(btScalar seconds) {
  std::vector<NearContact> near;
  for (const auto& [bodies, at] : near_) near.insert(near.end(), at.contacts.begin(), at.contacts.end());
  Carriers carriers(near, static_cast<btScalar>(options_.gap), seconds);
  carriers.take_speed();
  std::optional<Step> way;
  carriers.part([&] { way.emplace(*this, seconds); });
  const Step& step = *way;
  adapters::ClampedStep clamped;
  set_overlapping_may_touch(false);
  try {
    clamped = adapters::clamp(bodies_, step, overlapping_, options_);
  } catch (...) {
    set_overlapping_may_touch(true);
    throw;
  }
  set_overlapping_may_touch(true);
  limits_ = std::move(clamped.limits);
  last_step_ = {{}, clamped.questions, overlapping_.size()};
  for (std::size_t i = 0; i < clamped.fractions.size(); ++i) {
    const BodyId id = step.moving()[i];
    Member& member = members_.at(id);
    btRigidBody* const body = btRigidBody::upcast(member.object);
    body->setHitFraction(static_cast<btScalar>(clamped.fractions[i]));
    const btTransform start = member.place, end = step.place(id, clamped.fractions[i]);
    body->proceedToTransform(end);
    show_way(*body, start, end, seconds);
    if (clamped.fractions[i] < kStands) {
      body->setLinearVelocity(kKeptSpeed * body->getLinearVelocity());
      body->setAngularVelocity(kKeptSpeed * body->getAngularVelocity());
    }
    put(id, member);
    last_step_.moved.emplace_back(body, clamped.fractions[i]);
  }
}

}  // namespace tamis::bullet

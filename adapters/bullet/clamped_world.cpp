#include "adapters/bullet/clamped_world.hpp"

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <LinearMath/btTransformUtil.h>

#include <algorithm>
#include <cmath>

#include "adapters/bullet/mesh_of_shape.hpp"

namespace tamis::bullet {
namespace {

double radius_of(const Shape& mesh) {
  double radius = 0;
  for (const Point& p : mesh.points()) radius = std::max(radius, std::hypot(p[0], p[1], p[2]));
  return radius;
}

BodyMotion motion_at(const btCollisionObject& object, const Pose& pose) {
  return object.isStaticObject() ? BodyMotion(Static{pose}) : adapters::resting(pose);
}

/// Does Bullet move it?
bool moves(const btRigidBody& body) { return body.isActive() && !body.isStaticOrKinematicObject(); }

}  // namespace

/// How a body is to move in one step, of which a part can be asked for. Bullet's solver may have moved it already, out
/// of a margin that it was deep in (split impulse): that is part of the way, which begins where the last step ended.
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
    for (const auto& [id, member] : world.members_) {
      btRigidBody* const body = btRigidBody::upcast(member.object);
      if (!body || !moves(*body)) continue;
      btTransform end;
      body->predictIntegratedTransform(seconds, end);
      ways_.emplace(id, Way(member.place, end));
      moving_.push_back(id);
    }
  }

  std::span<const BodyId> moving() const override { return moving_; }
  Pose pose(BodyId body, double fraction) const override { return pose_of(place(body, fraction)); }
  double radius(BodyId body) const override { return world_.members_.at(body).radius; }
  bool collides(const adapters::BodyPair& bodies) const override { return world_.collides(bodies); }

  btTransform place(BodyId body, double fraction) const { return ways_.at(body).at(fraction); }

 private:
  const ClampedWorld& world_;
  std::vector<BodyId> moving_;
  std::map<BodyId, Way> ways_;
};

ClampedWorld::ClampedWorld(btDispatcher* dispatcher, btBroadphaseInterface* broadphase, btConstraintSolver* solver,
                           btCollisionConfiguration* configuration, adapters::ClampOptions options, int threads)
    : btDiscreteDynamicsWorld(dispatcher, broadphase, solver, configuration),
      options_(options),
      bodies_(Options{.threads = threads}) {}

void ClampedWorld::set_mesh(const btCollisionShape& shape, const Shape& mesh) { given_.insert_or_assign(&shape, mesh); }

Shape ClampedWorld::mesh_for(const btCollisionShape* shape) const {
  if (const auto given = given_.find(shape); given != given_.end()) return given->second;
  for (const auto& [id, member] : members_)
    if (member.shape == shape) return member.mesh;
  return mesh_of(*shape);
}

void ClampedWorld::join(btCollisionObject* object) {
  const btCollisionShape* const shape = object->getCollisionShape();
  const Shape mesh = mesh_for(shape);
  const btTransform& place = object->getWorldTransform();
  const BodyId id = bodies_.add(mesh, motion_at(*object, pose_of(place)));
  members_.emplace(id, Member{object, shape, mesh, radius_of(mesh), place});
}

void ClampedWorld::leave(const btCollisionObject* object) {
  const auto found = std::ranges::find_if(members_, [&](const auto& entry) { return entry.second.object == object; });
  if (found == members_.end()) return;
  bodies_.remove(found->first);
  members_.erase(found);
}

void ClampedWorld::addCollisionObject(btCollisionObject* object, int group, int mask) {
  try {
    if (object->hasContactResponse()) join(object);
  } catch (...) {
    if (btRigidBody* const body = btRigidBody::upcast(object)) m_nonStaticRigidBodies.remove(body);
    throw;
  }
  btDiscreteDynamicsWorld::addCollisionObject(object, group, mask);
}

void ClampedWorld::removeCollisionObject(btCollisionObject* object) {
  leave(object);
  btDiscreteDynamicsWorld::removeCollisionObject(object);
}

void ClampedWorld::removeRigidBody(btRigidBody* body) {
  leave(body);
  btDiscreteDynamicsWorld::removeRigidBody(body);
}

void ClampedWorld::put(BodyId id, Member& member) {
  member.place = member.object->getWorldTransform();
  bodies_.move(id, motion_at(*member.object, pose_of(member.place)));
}

/// What was moved, or given another shape, from outside since the last step.
void ClampedWorld::follow() {
  std::vector<btCollisionObject*> changed;
  for (auto& [id, member] : members_) {
    if (member.object->getCollisionShape() != member.shape) changed.push_back(member.object);
    if (!(member.place == member.object->getWorldTransform())) put(id, member);
  }
  for (btCollisionObject* const object : changed) {
    leave(object);
    join(object);
  }
}

bool ClampedWorld::collides(const adapters::BodyPair& bodies) const {
  btCollisionObject *const a = members_.at(bodies[0]).object, *const b = members_.at(bodies[1]).object;
  const btOverlappingPairCache& pairs = *getBroadphase()->getOverlappingPairCache();
  return pairs.needsBroadphaseCollision(a->getBroadphaseHandle(), b->getBroadphaseHandle()) &&
         m_dispatcher1->needsCollision(a, b);
}

class ClampedWorld::Predicted {
 public:
  explicit Predicted(ClampedWorld& world) : world_(world) {}

  /// `direction`: from the second feature to the first.
  void add(const std::array<BodyId, 2>& bodies, PairKind kind, const std::array<Index, 4>& vertices, double u, double v,
           const Point& direction) {
    const adapters::BodyPair pair = adapters::pair_of(bodies);
    if (!world_.members_.contains(pair[0]) || !world_.members_.contains(pair[1])) return;
    if (world_.overlapping_.contains(pair) || !world_.collides(pair)) return;
    const auto local = closest_points(bodies, kind, vertices, weights_of(kind, u, v));
    btPersistentManifold& manifold = manifold_of(bodies);
    const btCollisionObject *const first = manifold.getBody0(), *const second = manifold.getBody1();
    btManifoldPoint point(local[0], local[1], vector_of(direction), 0);
    point.m_positionWorldOnA = first->getWorldTransform() * local[0];
    point.m_positionWorldOnB = second->getWorldTransform() * local[1];
    point.m_distance1 = (point.m_positionWorldOnA - point.m_positionWorldOnB).dot(point.m_normalWorldOnB) -
                        static_cast<btScalar>(world_.options_.gap);
    point.m_combinedFriction = btManifoldResult::calculateCombinedFriction(first, second);
    point.m_combinedRestitution = btManifoldResult::calculateCombinedRestitution(first, second);
    manifold.addManifoldPoint(point, true);
  }

 private:
  /// Each in its own body's frame.
  std::array<btVector3, 2> closest_points(const std::array<BodyId, 2>& bodies, PairKind kind,
                                          const std::array<Index, 4>& vertices,
                                          const std::array<double, 4>& weights) const {
    const std::size_t of_first = kind == PairKind::edge_edge ? 2 : 1;
    std::array<btVector3, 2> points{btVector3(0, 0, 0), btVector3(0, 0, 0)};
    for (std::size_t i = 0; i < 4; ++i) {
      if (vertices[i] < 0) continue;
      const std::size_t side = i < of_first ? 0 : 1;
      const double share = side == 0 ? weights[i] : -weights[i];
      const std::vector<Point>& all = world_.members_.at(bodies[side]).mesh.points();
      points[side] += vector_of(all[static_cast<std::size_t>(vertices[i])]) * static_cast<btScalar>(share);
    }
    return points;
  }

  btPersistentManifold& manifold_of(const std::array<BodyId, 2>& bodies) {
    btPersistentManifold*& manifold = manifolds_[bodies];
    if (!manifold) {
      manifold = world_.m_dispatcher1->getNewManifold(world_.members_.at(bodies[0]).object,
                                                      world_.members_.at(bodies[1]).object);
      world_.m_predictiveManifolds.push_back(manifold);
    }
    return *manifold;
  }

  ClampedWorld& world_;
  std::map<std::array<BodyId, 2>, btPersistentManifold*> manifolds_;
};

void ClampedWorld::createPredictiveContacts(btScalar seconds) {
  btDiscreteDynamicsWorld::createPredictiveContacts(seconds);
  follow();
  overlapping_ = adapters::overlapping(bodies_);
  Predicted predicted(*this);
  for (const BodyNearPair& near : bodies_.pairs_within(2 * options_.gap))
    if (near.distance > 0) predicted.add(near.bodies, near.kind, near.vertices, near.u, near.v, near.direction);
  for (const BodyContact& limit : limits_)
    predicted.add(limit.bodies, limit.kind, limit.vertices, limit.u, limit.v, limit.normal);
}

void ClampedWorld::integrateTransforms(btScalar seconds) {
  const Step step(*this, seconds);
  adapters::ClampedStep clamped = adapters::clamp(bodies_, step, overlapping_, options_);
  limits_ = std::move(clamped.limits);
  last_step_ = {{}, clamped.questions, overlapping_.size()};
  for (std::size_t i = 0; i < clamped.fractions.size(); ++i) {
    const BodyId id = step.moving()[i];
    Member& member = members_.at(id);
    btRigidBody* const body = btRigidBody::upcast(member.object);
    body->setHitFraction(static_cast<btScalar>(clamped.fractions[i]));
    body->proceedToTransform(step.place(id, clamped.fractions[i]));
    put(id, member);
    last_step_.moved.emplace_back(body, clamped.fractions[i]);
  }
}

}  // namespace tamis::bullet

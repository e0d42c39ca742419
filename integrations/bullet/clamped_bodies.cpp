// Which bodies the clamp knows: objects that come, go, get other shapes, or are moved from outside.
#include <algorithm>
#include <set>
#include <string>

#include "integrations/bullet/clamped_world.hpp"
#include "integrations/bullet/mesh_of_shape.hpp"
#include "tamis/error.hpp"

namespace tamis::bullet {

ClampedWorld::Surface::Surface(const Shape& shape) : mesh(shape), radius(0) {
  for (const Point& p : mesh.points()) radius = std::max(radius, adapters::length(p));
}

BodyMotion ClampedWorld::motion_at(const btCollisionObject& object, const Pose& pose) {
  return object.isStaticObject() || !object.isActive() ? BodyMotion(Static{pose}) : adapters::resting(pose);
}

void ClampedWorld::set_mesh(const btCollisionShape& shape, const Shape& mesh) {
  given_.insert_or_assign(&shape, KnownShape{&shape, traits_of(shape), std::make_shared<const Surface>(mesh)});
  std::vector<btCollisionObject*> with_shape;
  for (const auto& [id, member] : members_)
    if (member.shape.shape == &shape) with_shape.push_back(member.object);
  for (btCollisionObject* const object : with_shape) take_anew(object, known(&shape));
}

ClampedWorld::KnownShape ClampedWorld::known(const btCollisionShape* shape) const {
  std::vector<btScalar> traits = traits_of(*shape);
  const auto is_it = [&](const KnownShape& other) { return other.shape == shape && other.traits == traits; };
  if (const auto given = given_.find(shape); given != given_.end() && is_it(given->second)) return given->second;
  for (const auto& [id, member] : members_)
    if (is_it(member.shape)) return member.shape;
  return {shape, std::move(traits), std::make_shared<const Surface>(mesh_of(*shape))};
}

ClampedWorld::KnownShape ClampedWorld::known_of(const btCollisionObject& object) const {
  try {
    return known(object.getCollisionShape());
  } catch (const InvalidMesh& refused) {
    const Point p = point_of(object.getWorldTransform().getOrigin());
    throw InvalidMesh("the object at " + std::to_string(p[0]) + ", " + std::to_string(p[1]) + ", " +
                      std::to_string(p[2]) + ": " + refused.what());
  }
}

void ClampedWorld::join(btCollisionObject* object, const KnownShape& shape) {
  const btTransform& place = object->getWorldTransform();
  const Pose pose = pose_of(place);
  are_apart_ = false;
  const BodyId id = bodies_.add(shape.surface->mesh, motion_at(*object, pose));
  members_.emplace(id, Member{object, shape, place, pose, object->isActive()});
}

void ClampedWorld::leave(const btCollisionObject* object) {
  const auto found = std::ranges::find_if(members_, [&](const auto& entry) { return entry.second.object == object; });
  if (found == members_.end()) return;
  are_apart_ = false;
  bodies_.remove(found->first);
  members_.erase(found);
}

void ClampedWorld::take_anew(btCollisionObject* object, const KnownShape& shape) {
  leave(object);
  join(object, shape);
}

void ClampedWorld::addCollisionObject(btCollisionObject* object, int group, int mask) {
  try {
    if (object->hasContactResponse()) join(object, known_of(*object));
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
  const btTransform& place = member.object->getWorldTransform();
  const Pose pose = pose_of(place);
  bodies_.move(id, motion_at(*member.object, pose));
  member.place = place;
  member.pose = pose;
  member.is_active = member.object->isActive();
}

void ClampedWorld::forget_limits_of(BodyId id) {
  std::erase_if(limits_, [&](const BodyContact& limit) { return std::ranges::count(limit.bodies, id) > 0; });
}

/// Updates all objects that, since the last step, were moved from outside, got another or a changed shape, or became
/// solid.
void ClampedWorld::follow() {
  std::map<const btCollisionShape*, std::vector<btScalar>> traits;
  std::set<const btCollisionObject*> followed;
  std::vector<btCollisionObject*> changed;
  for (auto& [id, member] : members_) {
    followed.insert(member.object);
    const btCollisionShape* const shape = member.object->getCollisionShape();
    const auto [now, is_new] = traits.try_emplace(shape);
    if (is_new) now->second = traits_of(*shape);
    if (shape != member.shape.shape || now->second != member.shape.traits) changed.push_back(member.object);
    const bool is_elsewhere = !(member.place == member.object->getWorldTransform());
    if (is_elsewhere) forget_limits_of(id);
    if (!is_elsewhere && member.is_active == member.object->isActive()) continue;
    are_apart_ = false;
    put(id, member);
  }
  for (int i = 0; i < getNumCollisionObjects(); ++i) {
    btCollisionObject* const object = getCollisionObjectArray()[i];
    if (object->hasContactResponse() && !followed.contains(object)) join(object, known_of(*object));
  }
  for (btCollisionObject* const object : changed)
    take_anew(object, known_of(*object));  // a refused object stays as it was: the step ends here
}

}  // namespace tamis::bullet

#include "integrations/bullet/solver_contacts.hpp"

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <algorithm>

#include "integrations/bullet/mesh_of_shape.hpp"

namespace tamis::bullet {

SolverContacts::SolverContacts(btDispatcher& dispatcher, const Manifolds& last) : dispatcher_(dispatcher) {
  for (int i = 0; i < last.size(); ++i) {
    std::vector<btManifoldPoint>& points = last_[{last[i]->getBody0(), last[i]->getBody1()}];
    for (int k = 0; k < last[i]->getNumContacts(); ++k) points.push_back(last[i]->getContactPoint(k));
  }
}

void SolverContacts::add(const Objects& objects, const adapters::NearContact& contact, double gap, Manifolds& all) {
  const auto& [first, second] = objects;
  btPersistentManifold*& manifold = manifolds_[objects];
  if (!manifold) {
    manifold = dispatcher_.getNewManifold(first, second);
    all.push_back(manifold);
  }
  const std::array points{vector_of(contact.points[0]), vector_of(contact.points[1])};
  btManifoldPoint point(first->getWorldTransform().invXform(points[0]), second->getWorldTransform().invXform(points[1]),
                        vector_of(contact.normal), static_cast<btScalar>(std::max(0.0, contact.distance() - gap)));
  point.m_positionWorldOnA = points[0];
  point.m_positionWorldOnB = points[1];
  point.m_combinedFriction = gCalculateCombinedFrictionCallback(first, second);
  point.m_combinedRestitution = gCalculateCombinedRestitutionCallback(first, second);
  point.m_combinedRollingFriction = gCalculateCombinedRollingFrictionCallback(first, second);
  point.m_combinedSpinningFriction = gCalculateCombinedSpinningFrictionCallback(first, second);
  if (const int known = manifold->getCacheEntry(point); known < 0)
    manifold->addManifoldPoint(point, true);
  else if (point.getDistance() < manifold->getContactPoint(known).getDistance())
    manifold->replaceContactPoint(point, known);
}

void SolverContacts::start_warm() {
  for (const auto& [objects, manifold] : manifolds_)
    for (const btManifoldPoint& last : last_[objects])
      if (const int known = manifold->getCacheEntry(last); known >= 0)
        manifold->getContactPoint(known).m_appliedImpulse += last.m_appliedImpulse;
}

}  // namespace tamis::bullet

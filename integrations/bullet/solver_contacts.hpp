// The contact points that Bullet's solver gets for features near each other.
#pragma once
#include <btBulletDynamicsCommon.h>

#include <array>
#include <map>
#include <vector>

#include "integrations/near_contacts.hpp"

namespace tamis::bullet {

/// Is it a rigid body that Bullet moves?
inline bool moves(const btCollisionObject& object) {
  return btRigidBody::upcast(&object) && object.isActive() && !object.isStaticOrKinematicObject();
}

/// Contact points of near pairs for Bullet's solver, made anew in each step; those of two objects share a manifold. The
/// solver begins with the impulses with which it ended in the last step, as for Bullet's own contacts: a pile needs
/// more rounds than one step has.
class SolverContacts {
 public:
  using Manifolds = btAlignedObjectArray<btPersistentManifold*>;
  using Objects = std::array<const btCollisionObject*, 2>;

  /// `last`: manifolds of the last step; read by the constructor only.
  SolverContacts(btDispatcher& dispatcher, const Manifolds& last);

  /// Adds a contact at which the solver keeps the objects `gap` apart; appends to `all` the manifold that is made for
  /// it, if any.
  void add(const Objects& objects, const adapters::NearContact& contact, double gap, Manifolds& all);
  void start_warm();

 private:
  btDispatcher& dispatcher_;
  std::map<Objects, std::vector<btManifoldPoint>> last_;
  std::map<Objects, btPersistentManifold*> manifolds_;
};

}  // namespace tamis::bullet

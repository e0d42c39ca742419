// Where bodies are near each other, as Bullet's solver is told.
#pragma once
#include <btBulletDynamicsCommon.h>

#include <map>
#include <vector>

#include "adapters/clamp.hpp"

namespace tamis::bullet {

/// Is it a rigid body that Bullet moves?
inline bool moves(const btCollisionObject& object) {
  return btRigidBody::upcast(&object) && object.isActive() && !object.isStaticOrKinematicObject();
}

/// One body of a near pair.
struct NearSide {
  btCollisionObject* object;
  btVector3 local;  ///< its point, in its own frame

  btVector3 point() const { return object->getWorldTransform() * local; }
};

struct NearContact {
  adapters::BodyPair bodies;
  std::array<NearSide, 2> sides;
  btVector3 normal;  ///< of length 1, from the second to the first

  btScalar distance() const { return (sides[0].point() - sides[1].point()).dot(normal); }
};

/// What bodies of one shape share.
struct Surface {
  explicit Surface(const Shape& shape);

  Shape mesh;
  double radius;                             ///< how far its points are from the origin, at most
  std::vector<std::vector<Index>> faces_at;  ///< of each vertex
};

/// A feature of a body: of a near pair, the vertices of one side, with the weights of the point that is nearest.
struct NearFeature {
  btCollisionObject* object;
  const Surface& surface;
  std::vector<Index> vertices;
  std::vector<double> weights;

  NearSide side() const;
  /// Do the faces around the point lead away from what is beyond it in the direction `outward` (of the world), but for
  /// a few degrees? If not, a point beside it is nearer, and this is no direction in which to push: two edges of boxes
  /// that lie exactly on each other would push sidewards, and so would an edge between two coplanar faces.
  bool is_nearest(const btVector3& outward) const;
};

/// Bullet's contact points of near pairs, anew in each step; those of two objects share a manifold. The solver begins
/// with the impulses with which it has ended in the last step, as it does for Bullet's own contacts: a pile needs more
/// rounds than one step has.
class SolverContacts {
 public:
  using Manifolds = btAlignedObjectArray<btPersistentManifold*>;

  /// `last`: manifolds of the last step, read here only.
  SolverContacts(btDispatcher& dispatcher, const Manifolds& last);

  /// The solver keeps these `gap` apart. Adds to `all` a manifold that is needed for it.
  void add(const NearContact& contact, btScalar gap, Manifolds& all);
  void start_warm();

 private:
  using Objects = std::array<const btCollisionObject*, 2>;

  btDispatcher& dispatcher_;
  std::map<Objects, std::vector<btManifoldPoint>> last_;
  std::map<Objects, btPersistentManifold*> manifolds_;
};

}  // namespace tamis::bullet

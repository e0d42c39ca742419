// Pairs of features near each other, and the contact points that Bullet's solver gets for them.
#pragma once
#include <btBulletDynamicsCommon.h>

#include <array>
#include <map>
#include <span>
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
  btVector3 local;  ///< the point of this body, in its own frame

  btVector3 point() const { return object->getWorldTransform() * local; }
};

struct NearContact {
  adapters::BodyPair bodies;
  std::array<NearSide, 2> sides;
  btVector3 normal;  ///< unit vector from the second to the first

  btScalar distance() const { return (sides[0].point() - sides[1].point()).dot(normal); }
};

/// The mesh that bodies of one shape share.
struct Surface {
  explicit Surface(const Shape& shape);

  Shape mesh;
  double radius;                            ///< the largest distance of its points from the origin
  std::vector<btVector3> points;            ///< of the mesh, in Bullet's floats
  std::vector<std::vector<Face>> faces_at;  ///< for each vertex the faces that it belongs to
};

/// Of contacts of two bodies those that say as much as all, in the same order: among contacts with one normal (within
/// about a thousandth), the nearest, and the farthest in each of eight directions along the plane. Two boxes that lie
/// on each other have some sixty pairs of near features, and a support of four corners.
std::vector<NearContact> essential(std::span<const NearContact> contacts);

/// One feature of a near pair: its vertices, with the weights of its nearest point. Keeps references.
struct NearFeature {
  /// Entries of `vertices` below 0 are none.
  NearFeature(const Surface& surface, std::span<const Index> vertices, const std::array<double, 3>& weights);

  const Surface& surface;
  std::span<const Index> vertices;
  std::array<double, 3> weights;
  std::size_t heaviest;  ///< the place of the largest weight
  btVector3 point;       ///< the nearest one, in the frame of the body

  bool is_vertex() const { return weights[heaviest] == 1; }
  /// Is it a face, and has a face before it the point, too? The pair of that one says as much.
  bool is_repeated() const;
  /// Do the faces around the point lead away from the direction `outward` (in the body's frame), up to a few degrees?
  /// If not, a point beside it is nearer, and `outward` is no direction in which to push: two edges of boxes that lie
  /// exactly on each other would push sideways, and so would an edge between two coplanar faces.
  bool is_nearest(const btVector3& outward) const;

 private:
  std::span<const Face> faces() const;   ///< at the heaviest vertex
  bool lies_on(const Face& face) const;  ///< one of faces()
};

/// Contact points of near pairs for Bullet's solver, made anew in each step; those of two objects share a manifold. The
/// solver begins with the impulses with which it ended in the last step, as for Bullet's own contacts: a pile needs
/// more rounds than one step has.
class SolverContacts {
 public:
  using Manifolds = btAlignedObjectArray<btPersistentManifold*>;

  /// `last`: manifolds of the last step; read by the constructor only.
  SolverContacts(btDispatcher& dispatcher, const Manifolds& last);

  /// Adds a contact at which the solver keeps the bodies `gap` apart; appends to `all` the manifold that is made for
  /// it, if any.
  void add(const NearContact& contact, btScalar gap, Manifolds& all);
  void start_warm();

 private:
  using Objects = std::array<const btCollisionObject*, 2>;

  btDispatcher& dispatcher_;
  std::map<Objects, std::vector<btManifoldPoint>> last_;
  std::map<Objects, btPersistentManifold*> manifolds_;
};

}  // namespace tamis::bullet

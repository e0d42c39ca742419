// The surface of a Bullet shape as a mesh.
#pragma once
#include <btBulletCollisionCommon.h>

#include <vector>

#include "tamis/world.hpp"

namespace tamis::bullet {

Point point_of(const btVector3& v);
/// Rounds to Bullet's btScalar.
btVector3 vector_of(const Point& p);
/// The pose of a transform whose entries are floats.
Pose pose_of(const btTransform& transform);

/// The triangles of meshes (also btGImpact's; call its updateBound first) and of height fields, the faces of convex
/// polyhedra (boxes, hulls, btConvexTriangleMeshShape), and compounds of these; scaled as the shape is. The margin that
/// Bullet puts around a shape is not part of its mesh. Throws InvalidMesh, saying what to do, for all other shapes
/// (round shapes have no triangles, planes no end), and for shapes whose list of triangles is empty.
Shape mesh_of(const btCollisionShape& shape);

/// What distinguishes a shape from what it was before, or from another one that was made at the same address since: its
/// kind, scale and box, the corners of a polyhedron, the children of a compound with their places. The vertices of a
/// mesh are not read: a mesh that is rewritten in place within its box has the same traits.
std::vector<btScalar> traits_of(const btCollisionShape& shape);

}  // namespace tamis::bullet

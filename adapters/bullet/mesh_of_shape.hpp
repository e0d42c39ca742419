// The surface of a Bullet shape as a mesh.
#pragma once
#include <btBulletCollisionCommon.h>

#include <vector>

#include "tamis/world.hpp"

namespace tamis::bullet {

Point point_of(const btVector3& v);
/// Rounded to what Bullet keeps.
btVector3 vector_of(const Point& p);
/// Of Bullet's floats as they are.
Pose pose_of(const btTransform& transform);

/// Meshes (also of btGImpact; call its updateBound first) and height fields triangle by triangle, convex polyhedra
/// (boxes, hulls) by their faces, compounds of these; scaled as the shape is. A margin that Bullet puts around a shape
/// is not part of its mesh. Throws InvalidMesh, saying what to do, for others: round shapes have no triangles, planes
/// no end; and for shapes without triangles.
Shape mesh_of(const btCollisionShape& shape);

/// What tells a shape from what it was before, or from another one that was made at the same address since: its kind,
/// scale and box, the corners of a polyhedron, the children of a compound with their places. The vertices of a mesh are
/// not read: one that is rewritten in place within its box looks the same.
std::vector<btScalar> traits_of(const btCollisionShape& shape);

}  // namespace tamis::bullet

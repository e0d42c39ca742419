#include "integrations/bullet/mesh_of_shape.hpp"

#include <BulletCollision/CollisionShapes/btConvexTriangleMeshShape.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>
#include <LinearMath/btConvexHullComputer.h>

#include <map>
#include <string>

#include "tamis/error.hpp"

namespace tamis::bullet {
namespace {

std::vector<btVector3> corners_of(const btPolyhedralConvexShape& shape) {
  std::vector<btVector3> corners;
  if (shape.getShapeType() == CONVEX_TRIANGLEMESH_SHAPE_PROXYTYPE) {  // it counts no vertices; they are its mesh's
    struct Corners : btInternalTriangleIndexCallback {
      void internalProcessTriangleIndex(btVector3* triangle, int, int) override {
        all.insert(all.end(), triangle, triangle + 3);
      }
      std::vector<btVector3> all;
    } of_mesh;
    const btVector3 far(BT_LARGE_FLOAT, BT_LARGE_FLOAT, BT_LARGE_FLOAT);
    static_cast<const btConvexTriangleMeshShape&>(shape).getMeshInterface()->InternalProcessAllTriangles(&of_mesh, -far,
                                                                                                         far);
    return of_mesh.all;
  }
  corners.resize(static_cast<std::size_t>(shape.getNumVertices()));
  for (int i = 0; i < shape.getNumVertices(); ++i) shape.getVertex(i, corners[static_cast<std::size_t>(i)]);
  return corners;
}

/// What to do with a shape that has an empty list of triangles.
std::string advice_on_empty(const btCollisionShape& shape) {
  const std::string give = "give a mesh for it with ClampedWorld::set_mesh, before the body is added";
  if (shape.getShapeType() == EMPTY_SHAPE_PROXYTYPE)
    return "give its object CF_NO_CONTACT_RESPONSE, so that it is not looked at";
  if (shape.getShapeType() != GIMPACT_SHAPE_PROXYTYPE) return "fill it before the body is added, or " + give;
  if (static_cast<const btGImpactShapeInterface&>(shape).getGImpactShapeType() == CONST_GIMPACT_COMPOUND_SHAPE)
    return "put the children of a btGImpactCompoundShape into a btCompoundShape, or " + give;
  return "call its updateBound before the body is added, or " + give;
}

/// The triangles of a shape, with one vertex for all corners at one place.
class Gathered : public btTriangleCallback {
 public:
  void add(const btCollisionShape& shape, const btTransform& place) {
    place_ = place;
    if (shape.isCompound())
      add_compound(static_cast<const btCompoundShape&>(shape), place);
    else if (shape.isPolyhedral())
      add_polyhedron(static_cast<const btPolyhedralConvexShape&>(shape));
    else if (shape.isConcave() && !shape.isInfinite())
      static_cast<const btConcaveShape&>(shape).processAllTriangles(this, everywhere(-1), everywhere(1));
    else
      throw InvalidMesh(std::string("the Bullet shape ") + shape.getName() +
                        " has no triangles of its own: give a mesh for it with ClampedWorld::set_mesh, before the body "
                        "is added; where it is part of a compound, one for the whole compound");
  }

  void processTriangle(btVector3* triangle, int, int) override {
    faces_.push_back({vertex(triangle[0]), vertex(triangle[1]), vertex(triangle[2])});
  }

  Shape shape_like(const btCollisionShape& shape) && {
    if (faces_.empty())
      throw InvalidMesh(std::string("the Bullet shape ") + shape.getName() +
                        " has no triangles: " + advice_on_empty(shape));
    return {Mesh(static_cast<Index>(points_.size()), faces_), std::move(points_)};
  }

 private:
  static btVector3 everywhere(btScalar sign) {
    const btScalar far = sign * BT_LARGE_FLOAT;
    return {far, far, far};
  }

  void add_compound(const btCompoundShape& compound, const btTransform& place) {
    for (int i = 0; i < compound.getNumChildShapes(); ++i)
      add(*compound.getChildShape(i), place * compound.getChildTransform(i));
  }

  void add_polyhedron(const btPolyhedralConvexShape& shape) {
    const std::vector<btVector3> corners = corners_of(shape);
    btConvexHullComputer hull;
    hull.compute(corners.empty() ? nullptr : &corners[0].x(), sizeof(btVector3), static_cast<int>(corners.size()), 0,
                 0);
    // The hull computer rounds its vertices to a grid: take the corners that it was given instead.
    const auto corner = [&](int vertex) {
      return corners[static_cast<std::size_t>(hull.original_vertex_index[vertex])];
    };
    for (int face = 0; face < hull.faces.size(); ++face) {
      const btConvexHullComputer::Edge* const first = &hull.edges[hull.faces[face]];
      for (const auto* edge = first->getNextEdgeOfFace(); edge->getTargetVertex() != first->getSourceVertex();
           edge = edge->getNextEdgeOfFace()) {
        btVector3 triangle[]{corner(first->getSourceVertex()), corner(edge->getSourceVertex()),
                             corner(edge->getTargetVertex())};
        processTriangle(triangle, 0, 0);
      }
    }
  }

  Index vertex(const btVector3& local) {
    const Point point = point_of(place_ * local);
    const auto [known, is_new] = vertices_.try_emplace(point, static_cast<Index>(points_.size()));
    if (is_new) points_.push_back(point);
    return known->second;
  }

  btTransform place_;
  std::vector<Point> points_;
  std::vector<Face> faces_;
  std::map<Point, Index> vertices_;
};

void add(const btVector3& v, std::vector<btScalar>& traits) { traits.insert(traits.end(), {v.x(), v.y(), v.z()}); }

void add_corners(const btPolyhedralConvexShape& shape, std::vector<btScalar>& traits) {
  for (const btVector3& corner : corners_of(shape)) add(corner, traits);
}

void add_box(const btCollisionShape& shape, std::vector<btScalar>& traits) {
  btVector3 low, high;
  shape.getAabb(btTransform::getIdentity(), low, high);
  const btScalar around = shape.isConcave() ? shape.getMargin() : btScalar(0);  // a round shape's is its radius
  add(low + btVector3(around, around, around), traits);
  add(high - btVector3(around, around, around), traits);
}

void add_traits(const btCollisionShape& shape, std::vector<btScalar>& traits) {
  traits.push_back(static_cast<btScalar>(shape.getShapeType()));
  add(shape.getLocalScaling(), traits);
  if (shape.isPolyhedral()) return add_corners(static_cast<const btPolyhedralConvexShape&>(shape), traits);
  if (!shape.isCompound()) return add_box(shape, traits);
  const auto& compound = static_cast<const btCompoundShape&>(shape);
  for (int i = 0; i < compound.getNumChildShapes(); ++i) {
    const btTransform& place = compound.getChildTransform(i);
    for (int row = 0; row < 3; ++row) add(place.getBasis()[row], traits);
    add(place.getOrigin(), traits);
    add_traits(*compound.getChildShape(i), traits);
  }
}

}  // namespace

Point point_of(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

btVector3 vector_of(const Point& p) {
  return {static_cast<btScalar>(p[0]), static_cast<btScalar>(p[1]), static_cast<btScalar>(p[2])};
}

Pose pose_of(const btTransform& transform) {
  const btMatrix3x3& basis = transform.getBasis();
  return tamis::pose_of_matrix({point_of(basis[0]), point_of(basis[1]), point_of(basis[2])},
                               point_of(transform.getOrigin()));
}

Shape mesh_of(const btCollisionShape& shape) {
  Gathered gathered;
  gathered.add(shape, btTransform::getIdentity());
  return std::move(gathered).shape_like(shape);
}

std::vector<btScalar> traits_of(const btCollisionShape& shape) {
  std::vector<btScalar> traits;
  add_traits(shape, traits);
  return traits;
}

}  // namespace tamis::bullet

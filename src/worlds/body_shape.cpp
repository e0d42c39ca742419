#include "worlds/body_shape.hpp"

#include <string>

#include "api/enum_names.hpp"
#include "curves/motions/rigid_transform.hpp"
#include "numbers/finite.hpp"
#include "search/topology/at.hpp"
#include "search/topology/mean_edge.hpp"
#include "tamis/error.hpp"

namespace tamis {

BodyShape::BodyShape(Mesh m, std::vector<Point> at_rest, Isa isa)
    : mesh(std::move(m)), points(std::move(at_rest)), loose(mesh) {
  if (points.size() != at(mesh.vertex_count()))
    throw InvalidMesh("the shape has " + std::to_string(points.size()) + " points, its mesh " +
                      std::to_string(mesh.vertex_count()) + " vertices: give one point a vertex");
  for (const Index v : mesh.points()) {
    if (!is_finite(points[at(v)]))
      throw InvalidMesh("vertex " + std::to_string(v) + " of the shape is not finite: give finite points");
    radius = std::max(radius, farthest(points[at(v)], points[at(v)]));
  }
  validate_is_named(isa, "instruction set");
  edge = mean_edge(mesh, points);
  std::vector<Point> centers(at(item_count()));
  for (Index item = 0; item < item_count(); ++item) centers[at(item)] = box_at_rest(item).middle();
  tree = BoxTree(centers);
  boxes = tree.boxes([this](Index item) { return box_at_rest(item); });
}

Face BodyShape::corners_of(Index item) const {
  auto i = at(item);
  if (i < mesh.faces().size()) return mesh.faces()[i];
  i -= mesh.faces().size();
  if (i < loose.edges.size()) return {loose.edges[i][0], loose.edges[i][1], loose.edges[i][1]};
  const Index point = loose.points[i - loose.edges.size()];
  return {point, point, point};
}

const ClosedParts& BodyShape::closed_parts() const {
  const std::lock_guard lock(mutex_);
  if (!closed_parts_) closed_parts_.emplace(mesh, points);
  return *closed_parts_;
}

std::uint64_t BodyShape::memory_bytes() const {
  const std::lock_guard lock(mutex_);
  return held_bytes(tree, boxes, loose.edges, loose.points, closed_parts_);
}

}  // namespace tamis

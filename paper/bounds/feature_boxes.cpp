#include "paper/bounds/feature_boxes.hpp"

namespace tamis::lab {

void FeatureBoxes::update(const Mesh& mesh, const MovingPoints& points, double padding) {
  const auto at = [](Index i) { return static_cast<std::size_t>(i); };
  vertices.resize(at(mesh.vertex_count()));
  for (Index v : mesh.points()) vertices[at(v)] = Dop16::around(points[v], points.centre(), padding);
  edges.resize(mesh.edges().size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Edge& e = mesh.edges()[i];
    edges[i] = merge(vertices[at(e[0])], vertices[at(e[1])]);
  }
  faces.resize(mesh.faces().size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Face& f = mesh.faces()[i];
    faces[i] = merge(merge(vertices[at(f[0])], vertices[at(f[1])]), vertices[at(f[2])]);
  }
}

}  // namespace tamis::lab

#include "paper/topology/representatives.hpp"

namespace tamis::lab {

std::vector<TriangleFeatures> choose_representatives(const Mesh& mesh) {
  std::vector<TriangleFeatures> triangles;
  triangles.reserve(mesh.faces().size());
  for (Index f = 0; f < static_cast<Index>(mesh.faces().size()); ++f) {
    TriangleFeatures t{mesh.faces()[static_cast<std::size_t>(f)], mesh.edges_of_face(f), 0, 0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto bit = static_cast<std::uint8_t>(1U << k);
      const Index v = t.vertices[k], e = t.edges[k];
      const bool new_vertex = (k < 1 || v != t.vertices[0]) && (k < 2 || v != t.vertices[1]);
      const bool new_edge = e >= 0 && (k < 1 || e != t.edges[0]) && (k < 2 || e != t.edges[1]);
      if (new_vertex) t.all_vertices |= bit;
      if (new_vertex && mesh.faces_of_vertex(v)[0] == f) t.own_vertices |= bit;
      if (new_edge) t.all_edges |= bit;
      if (new_edge && mesh.faces_of_edge(e)[0] == f) t.own_edges |= bit;
    }
    triangles.push_back(t);
  }
  return triangles;
}

}  // namespace tamis::lab

#include "files/mesh/loose_features.hpp"

namespace tamis::io {

std::vector<Edge> rods_of(const Mesh& mesh) {
  std::vector<Edge> rods;
  for (std::size_t i = 0; i < mesh.edges().size(); ++i)
    if (mesh.faces_of_edge(static_cast<Index>(i)).empty()) rods.push_back(mesh.edges()[i]);
  return rods;
}

std::vector<Index> loose_points_of(const Mesh& mesh) {
  std::vector<bool> is_on_edge(static_cast<std::size_t>(mesh.vertex_count()));
  for (const Edge& edge : mesh.edges())
    for (const Index v : edge) is_on_edge[static_cast<std::size_t>(v)] = true;
  std::vector<Index> loose;
  for (const Index v : mesh.points())
    if (!is_on_edge[static_cast<std::size_t>(v)]) loose.push_back(v);
  return loose;
}

}  // namespace tamis::io

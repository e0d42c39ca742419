#include "topology/loose_features.hpp"

namespace tamis {

LooseFeatures::LooseFeatures(const Mesh& mesh) {
  std::vector<bool> is_covered(static_cast<std::size_t>(mesh.vertex_count()), false);
  for (const Face& face : mesh.faces())
    for (const Index v : face) is_covered[static_cast<std::size_t>(v)] = true;
  for (Index e = 0; e < static_cast<Index>(mesh.edges().size()); ++e) {
    if (!mesh.faces_of_edge(e).empty()) continue;
    edges.push_back(mesh.edges()[static_cast<std::size_t>(e)]);
    for (const Index v : edges.back()) is_covered[static_cast<std::size_t>(v)] = true;
  }
  for (const Index p : mesh.points())
    if (!is_covered[static_cast<std::size_t>(p)]) points.push_back(p);
}

}  // namespace tamis

#include "topology/loose_features.hpp"

#include <algorithm>

namespace tamis {

LooseFeatures::LooseFeatures(const Mesh& mesh) {
  const auto edge_count = static_cast<Index>(mesh.edges().size());
  for (Index e = 0; e < edge_count; ++e)
    if (mesh.faces_of_edge(e).empty()) edges.push_back(mesh.edges()[static_cast<std::size_t>(e)]);
  for (const Index p : mesh.points())
    if (mesh.faces_of_vertex(p).empty()) points.push_back(p);
  if (points.empty() || edges.empty()) return;
  std::vector<Index> ends;
  for (const Edge& edge : edges) ends.insert(ends.end(), edge.begin(), edge.end());
  std::sort(ends.begin(), ends.end());
  std::erase_if(points, [&](Index p) { return std::binary_search(ends.begin(), ends.end(), p); });
}

}  // namespace tamis

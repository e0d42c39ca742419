#include "search/topology/loose_features.hpp"

#include <algorithm>

namespace tamis {
namespace {

/// Removes the ends of the edges from the points.
void leave_out_ends(const std::vector<Edge>& edges, std::vector<Index>& points) {
  if (points.empty() || edges.empty()) return;
  std::vector<Index> ends;
  for (const Edge& edge : edges) ends.insert(ends.end(), edge.begin(), edge.end());
  std::sort(ends.begin(), ends.end());
  std::erase_if(points, [&](Index p) { return std::binary_search(ends.begin(), ends.end(), p); });
}

/// Adds the vertices that are a face by themselves, even if other features use them. One of several ranks may see this
/// face alone, and must know its point.
void add_point_faces(const Mesh& mesh, std::vector<Index>& points) {
  const std::size_t known = points.size();
  for (const Face& face : mesh.faces())
    if (face[0] == face[1] && face[1] == face[2]) points.push_back(face[0]);
  if (points.size() == known) return;
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

}  // namespace

LooseFeatures::LooseFeatures(const Mesh& mesh) {
  const auto edge_count = static_cast<Index>(mesh.edges().size());
  for (Index e = 0; e < edge_count; ++e)
    if (mesh.faces_of_edge(e).empty()) edges.push_back(mesh.edges()[static_cast<std::size_t>(e)]);
  for (const Index p : mesh.points())
    if (mesh.faces_of_vertex(p).empty()) points.push_back(p);
  leave_out_ends(edges, points);
  add_point_faces(mesh, points);
}

}  // namespace tamis

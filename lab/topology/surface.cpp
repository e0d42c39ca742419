#include "lab/topology/surface.hpp"

namespace tamis::lab {
namespace {

std::vector<Face> triangles_of_loose_features(const Mesh& mesh) {
  std::vector<Face> triangles;
  std::vector<bool> covered(static_cast<std::size_t>(mesh.vertex_count()), false);
  for (const Face& face : mesh.faces())
    for (Index v : face) covered[static_cast<std::size_t>(v)] = true;
  for (Index e = 0; e < static_cast<Index>(mesh.edges().size()); ++e) {
    if (!mesh.faces_of_edge(e).empty()) continue;
    const auto [a, b] = mesh.edges()[static_cast<std::size_t>(e)];
    triangles.push_back({a, b, b});
    covered[static_cast<std::size_t>(a)] = covered[static_cast<std::size_t>(b)] = true;
  }
  for (Index p : mesh.points())
    if (!covered[static_cast<std::size_t>(p)]) triangles.push_back({p, p, p});
  return triangles;
}

}  // namespace

Surface::Surface(const Mesh& mesh) : original_(mesh) {
  const std::vector<Face> added = triangles_of_loose_features(mesh);
  if (added.empty()) return;
  std::vector<Face> faces(mesh.faces().begin(), mesh.faces().end());
  faces.insert(faces.end(), added.begin(), added.end());
  completed_.emplace(mesh.vertex_count(), std::move(faces));
}

}  // namespace tamis::lab

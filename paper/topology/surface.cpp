#include "paper/topology/surface.hpp"

#include "search/topology/loose_features.hpp"

namespace tamis::lab {
namespace {

std::vector<Face> triangles_of_loose_features(const Mesh& mesh) {
  const LooseFeatures loose(mesh);
  std::vector<Face> triangles;
  for (const auto& [a, b] : loose.edges) triangles.push_back({a, b, b});
  for (const Index p : loose.points) triangles.push_back({p, p, p});
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

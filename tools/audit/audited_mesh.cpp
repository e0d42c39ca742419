#include "audit/audited_mesh.hpp"

#include <algorithm>

#include "tamis/error.hpp"

namespace tamis::audit {
namespace {

void require_one_each(const Mesh& mesh, const Objects& objects) {
  if (objects.of_vertex.size() != static_cast<std::size_t>(mesh.vertex_count()))
    throw InvalidMesh("objects has " + std::to_string(objects.of_vertex.size()) + " numbers for " +
                      std::to_string(mesh.vertex_count()) + " vertices: give the object of each vertex");
  if (std::any_of(objects.of_vertex.begin(), objects.of_vertex.end(), [](Index object) { return object < -1; }))
    throw InvalidMesh("objects has a number below -1: number the objects from 0, -1 being none");
}

}  // namespace

std::string Objects::name_of(Index object) const {
  const auto place = static_cast<std::size_t>(object);
  return object >= 0 && place < names.size() ? names[place] : std::to_string(object);
}

AuditedMesh::AuditedMesh(Mesh mesh, Objects objects)
    : mesh_(std::move(mesh)),
      objects_(std::move(objects)),
      components_(components_of(mesh_)),
      neighbours_(static_cast<std::size_t>(mesh_.vertex_count())) {
  for (const auto& [a, b] : mesh_.edges()) {
    neighbours_[static_cast<std::size_t>(a)].push_back(b);
    neighbours_[static_cast<std::size_t>(b)].push_back(a);
  }
  if (objects_.of_vertex.empty()) objects_.of_vertex = components_.of_vertex;
  require_one_each(mesh_, objects_);
}

}  // namespace tamis::audit

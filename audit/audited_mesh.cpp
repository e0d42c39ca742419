#include "audit/audited_mesh.hpp"

#include <algorithm>

#include "tamis/components.hpp"
#include "tamis/error.hpp"

namespace tamis::audit {
namespace {

IndexRows neighbours_of(const Mesh& mesh) {
  IndexRows rows;
  rows.offsets.assign(static_cast<std::size_t>(mesh.vertex_count()) + 1, 0);
  const auto place = [&](Index v) -> Index& { return rows.offsets[static_cast<std::size_t>(v)]; };
  for (const Edge& e : mesh.edges())
    for (const Index v : e) ++place(v);
  Index sum = 0;
  for (Index& offset : rows.offsets) sum += offset, offset = sum;
  rows.items.resize(static_cast<std::size_t>(sum));
  // Each row is filled from its end, so that its offset ends at its first item.
  for (const Edge& e : mesh.edges()) {
    rows.items[static_cast<std::size_t>(--place(e[0]))] = e[1];
    rows.items[static_cast<std::size_t>(--place(e[1]))] = e[0];
  }
  return rows;
}

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
      component_of_vertex_(components_of(mesh_).of_vertex),
      neighbours_(neighbours_of(mesh_)) {
  if (objects_.of_vertex.empty()) objects_.of_vertex = component_of_vertex_;
  require_one_each(mesh_, objects_);
}

}  // namespace tamis::audit

#include "c/mesh.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "c/kind.hpp"
#include "c/sized.hpp"
#include "tamis/contact.hpp"

namespace tamis::c {
namespace {

/// `count` rows of a caller's array of indices.
template <class Row>
std::vector<Row> rows(const int32_t* indices, std::size_t count, const char* name) {
  if (count > static_cast<std::size_t>(std::numeric_limits<Index>::max()))
    throw InvalidMesh(std::to_string(count) + " " + name + ": give at most 2^31 - 1");
  std::vector<Row> result(count);
  if (count > 0) std::copy_n(&required(indices, name), count * (sizeof(Row) / sizeof(Index)), &result.data()->front());
  return result;
}

Mesh make_mesh(const tamis_mesh_input& input) {
  const auto points = rows<std::array<Index, 1>>(input.loose_points, input.loose_point_count, "loose_points");
  std::vector<Index> loose_points;
  for (const auto& point : points) loose_points.push_back(point[0]);
  return Mesh(input.vertex_count, rows<Face>(input.faces, input.face_count, "faces"),
              rows<Edge>(input.loose_edges, input.loose_edge_count, "loose_edges"), loose_points);
}

template <class Row>
const int32_t* first_index(std::span<const Row> rows, std::size_t* count) {
  if (count) *count = rows.size();
  return rows.empty() ? nullptr : reinterpret_cast<const int32_t*>(rows.data());
}

/// Writes the place of each row, which `place_of` finds.
template <class Row, class PlaceOf>
tamis_status find(tamis_mesh* handle, const int32_t* indices, std::size_t count, int32_t* places,
                  const PlaceOf& place_of) noexcept {
  return with_object(handle, [&](const Mesh& mesh) {
    const std::vector<Row> asked = rows<Row>(indices, count, "rows");
    if (count > 0) required(places, "places");
    std::transform(asked.begin(), asked.end(), places, [&](const Row& row) { return place_of(mesh, row); });
  });
}

}  // namespace
}  // namespace tamis::c

using namespace tamis::c;

tamis_status tamis_mesh_create(const tamis_mesh_input* input, tamis_mesh** mesh) {
  return make_handle(mesh, [&](tamis_mesh& handle) { handle.object.emplace(make_mesh(read_sized(input, "input"))); });
}

void tamis_mesh_free(tamis_mesh* mesh) { delete mesh; }

const char* tamis_mesh_message(const tamis_mesh* mesh) { return message_of(mesh); }

const int32_t* tamis_mesh_edges(const tamis_mesh* mesh, size_t* count) {
  return first_index(mesh && mesh->object ? mesh->object->edges() : std::span<const tamis::Edge>(), count);
}

const int32_t* tamis_mesh_points(const tamis_mesh* mesh, size_t* count) {
  return first_index(mesh && mesh->object ? mesh->object->points() : std::span<const tamis::Index>(), count);
}

tamis_status tamis_mesh_features_of(tamis_mesh* mesh, int32_t kind, const int32_t* vertices, int32_t* first,
                                    int32_t* second) {
  return with_object(mesh, [&](const tamis::Mesh& made) {
    std::array<tamis::Index, 4> given;
    std::copy_n(&required(vertices, "vertices"), 4, given.begin());
    int32_t &one = required(first, "first"), &other = required(second, "second");
    const auto [a, b] = features_of(made, known_kind(kind), given);
    one = a;
    other = b;
  });
}

tamis_status tamis_mesh_find_edges(tamis_mesh* mesh, const int32_t* edges, size_t count, int32_t* places) {
  return find<tamis::Edge>(mesh, edges, count, places, [](const tamis::Mesh& made, const tamis::Edge& edge) {
    return made.find_edge(edge[0], edge[1]);
  });
}

tamis_status tamis_mesh_find_faces(tamis_mesh* mesh, const int32_t* faces, size_t count, int32_t* places) {
  return find<tamis::Face>(mesh, faces, count, places,
                           [](const tamis::Mesh& made, const tamis::Face& face) { return made.find_face(face); });
}

#include "tamis/mesh.hpp"

#include <algorithm>

#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"

namespace tamis::python {
namespace {

template <class Row>
nb::object index_rows(std::span<const Row> rows) {
  return own<Index>(std::vector<Row>(rows.begin(), rows.end()));
}

/// The place of each row, as `place_of` finds it.
template <class Row, class Rows, class PlaceOf>
nb::object places(const Rows& rows, const PlaceOf& place_of) {
  const auto* first = reinterpret_cast<const Row*>(rows.data());
  std::vector<Index> found(rows.shape(0));
  std::transform(first, first + rows.shape(0), found.begin(), place_of);
  return own<Index>(std::move(found));
}

nb::object find_edges(const Mesh& mesh, const IndexRowsIn<2>& edges) {
  return places<Edge>(edges, [&](const Edge& edge) { return mesh.find_edge(edge[0], edge[1]); });
}

nb::object find_faces(const Mesh& mesh, const IndexRowsIn<3>& faces) {
  return places<Face>(faces, [&](const Face& face) { return mesh.find_face(face); });
}

}  // namespace

void bind_mesh(nb::module_& module) {
  nb::class_<Mesh>(module, "Mesh")
      .def("__init__",
           [](Mesh* mesh, Index vertex_count, const IndexRowsIn<3>& faces, const IndexRowsIn<2>& edges,
              const Indices& points) {
             new (mesh) Mesh(vertex_count, copy_of<Face>(faces), copy_of<Edge>(edges), copy_of<Index>(points));
           })
      .def_prop_ro("vertex_count", &Mesh::vertex_count)
      .def("faces", [](const Mesh& mesh) { return index_rows(mesh.faces()); })
      .def("edges", [](const Mesh& mesh) { return index_rows(mesh.edges()); })
      .def("points", [](const Mesh& mesh) { return index_rows(mesh.points()); });
  module.def("find_edges", &find_edges);
  module.def("find_faces", &find_faces);
}

}  // namespace tamis::python

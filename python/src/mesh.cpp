#include "tamis/mesh.hpp"

#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"

namespace tamis::python {
namespace {

template <class Row>
nb::object index_rows(std::span<const Row> rows) {
  return own<Index>(std::vector<Row>(rows.begin(), rows.end()), sizeof(Row) / sizeof(Index));
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
      .def("points", [](const Mesh& mesh) {
        const auto points = mesh.points();
        return own<Index>(std::vector<Index>(points.begin(), points.end()), 0);
      });
}

}  // namespace tamis::python

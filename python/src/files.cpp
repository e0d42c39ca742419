// Mesh files, frames and tables, as the command reads and writes them.
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "io/bodies/bodies_csv.hpp"
#include "io/mesh/frames.hpp"
#include "io/mesh/mesh_file.hpp"
#include "io/mesh/ply.hpp"
#include "io/output/contacts_csv.hpp"
#include "io/view/outputs.hpp"
#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"
#include "python/src/contact_array.hpp"

namespace tamis::python {
namespace {

nb::tuple read_mesh(const std::filesystem::path& path) {
  io::MeshFile file;
  {
    const nb::gil_scoped_release unlocked;
    file = io::read_mesh(path);
  }
  return nb::make_tuple(own<double>(std::move(file.positions)), own<Index>(std::move(file.faces)),
                        own<Index>(std::move(file.loose_edges)), own<Index>(std::move(file.loose_points)), file.notes);
}

void write_mesh(const std::filesystem::path& path, const PointRows& positions, const IndexRowsIn<3>& faces,
                const IndexRowsIn<2>& edges, const Indices& points) {
  io::MeshFile file;
  file.positions = copy_of<Point>(positions);
  file.faces = copy_of<Face>(faces);
  file.loose_edges = copy_of<Edge>(edges);
  file.loose_points = copy_of<Index>(points);
  const nb::gil_scoped_release unlocked;
  io::write_ply(path, file);
}

void write_contacts(const std::filesystem::path& path, const ContactBytes& bytes) {
  const std::span<const Contact> contacts = contacts_in(bytes);
  const nb::gil_scoped_release unlocked;
  io::write_contacts_csv(path, contacts);
}

void write_body_contacts(const std::filesystem::path& path, const ContactBytes& bytes) {
  const auto contacts = contacts_in<BodyContact>(bytes);
  const nb::gil_scoped_release unlocked;
  io::write_body_contacts_csv(path, contacts);
}

/// Else a table. Throws io::FileError if nothing is written under such a name.
bool is_file_to_look_at(const std::filesystem::path& path) {
  return &io::output_for(path, io::outputs()) != io::outputs().data();
}

}  // namespace

void bind_files(nb::module_& module) {
  module.def("is_file_to_look_at", &is_file_to_look_at);
  module.def("read_mesh", &read_mesh);
  module.def("write_mesh", &write_mesh);
  module.def("write_contacts", &write_contacts);
  module.def("write_body_contacts", &write_body_contacts);
  module.def("frame_files", [](const std::vector<std::string>& names) { return io::frame_files(names); });
}

}  // namespace tamis::python

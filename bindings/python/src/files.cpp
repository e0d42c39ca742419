// Mesh files, frames and tables, as the command reads and writes them.
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "files/bodies/bodies_csv.hpp"
#include "files/mesh/frames.hpp"
#include "files/mesh/mesh_file.hpp"
#include "files/mesh/ply.hpp"
#include "files/mesh/polygons.hpp"
#include "files/mesh/weld.hpp"
#include "files/motion/mesh_frames.hpp"
#include "files/output/contacts_csv.hpp"
#include "files/view/outputs.hpp"
#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"
#include "python/src/contact_array.hpp"

namespace tamis::python {
namespace {

io::MeshFile read(const std::filesystem::path& path) {
  const nb::gil_scoped_release unlocked;
  return io::read_mesh(path);
}

nb::tuple tuple_of(io::MeshFile file) {
  return nb::make_tuple(own<double>(std::move(file.positions)), own<Index>(std::move(file.faces)),
                        own<Index>(std::move(file.loose_edges)), own<Index>(std::move(file.loose_points)), file.notes);
}

nb::tuple read_mesh(const std::filesystem::path& path) { return tuple_of(read(path)); }

/// Reads frames of one mesh.
class FrameReader {
 public:
  explicit FrameReader(const std::vector<std::string>& names)
      : paths_(io::frame_files(names)), gaps_(io::gaps_between(paths_)) {}

  std::size_t count() const { return paths_.size(); }
  nb::tuple first() {
    first_ = read(paths_.front());
    return tuple_of(first_);
  }
  /// Positions and notes of a later frame. Throws io::FileError unless it is of the first one's mesh.
  nb::tuple next(std::size_t i) const {
    io::MeshFile frame = read(paths_.at(i));
    io::require_same_mesh(first_, paths_.front().string(), frame, paths_[i].string());
    const auto said = frame.notes_of_later_frame();
    std::vector<std::string> notes(said.begin(), said.end());
    if (!gaps_[i].empty()) notes.push_back(gaps_[i]);
    return nb::make_tuple(own<double>(std::move(frame.positions)), notes);
  }

 private:
  std::vector<std::filesystem::path> paths_;
  std::vector<std::string> gaps_;
  io::MeshFile first_;
};

/// Triangles of polygons, and sentences on them.
nb::tuple cut_polygons(const Indices& counts, const Indices& corners, const Rows& points) {
  std::vector<Face> faces;
  io::Polygons polygons;
  polygons.cut_all({counts.data(), counts.size()}, {corners.data(), corners.size()}, points_of(positions(points)),
                   faces);
  return nb::make_tuple(own<Index>(std::move(faces)), polygons.doubts());
}

/// For each vertex the first one of those that lie together in every frame.
nb::object weld(const std::vector<Rows>& frames, double distance) {
  io::Weld weld(frames.front().shape(0), distance);
  for (const Rows& frame : frames) weld.add_frame(points_of(positions(frame)));
  return own<Index>(std::vector<Index>(weld.first_of_vertex()));
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
  nb::class_<FrameReader>(module, "FrameReader")
      .def(nb::init<const std::vector<std::string>&>())
      .def("count", &FrameReader::count)
      .def("first", &FrameReader::first)
      .def("next", &FrameReader::next);
  module.def("cut_polygons", &cut_polygons);
  module.def("weld", &weld);
}

}  // namespace tamis::python

#include <fmt/format.h>

#include <bit>
#include <string>
#include <string_view>

#include "files/atomic_file.hpp"
#include "files/mesh/ply.hpp"

namespace tamis::io {
namespace {

/// The byte order of this machine, which the header names: no bytes are swapped.
constexpr const char* kFormat =
    std::endian::native == std::endian::little ? "binary_little_endian" : "binary_big_endian";

std::string header_of(const MeshFile& mesh) {
  std::string header = fmt::format(
      "ply\nformat {} 1.0\n"
      "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
      "element face {}\nproperty list uchar int vertex_indices\n",
      kFormat, mesh.positions.size(), mesh.faces.size());
  if (!mesh.loose_edges.empty())
    header += fmt::format("element edge {}\nproperty int vertex1\nproperty int vertex2\n", mesh.loose_edges.size());
  if (!mesh.loose_points.empty())
    header += fmt::format("element point {}\nproperty int vertex\n", mesh.loose_points.size());
  return header + "end_header\n";
}

template <class T>
std::string_view bytes_of(const T& value) {
  return {reinterpret_cast<const char*>(&value), sizeof(T)};
}

}  // namespace

void write_ply(const std::filesystem::path& path, const MeshFile& mesh) {
  AtomicFile file(path);
  file.append(header_of(mesh));
  for (const Point& p : mesh.positions) file.append(bytes_of(p));
  for (const Face& f : mesh.faces) {
    file.append("\3");
    file.append(bytes_of(f));
  }
  for (const Edge& e : mesh.loose_edges) file.append(bytes_of(e));
  for (const Index& v : mesh.loose_points) file.append(bytes_of(v));
  file.commit();
}

}  // namespace tamis::io

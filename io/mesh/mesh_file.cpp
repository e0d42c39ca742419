#include "io/mesh/mesh_file.hpp"

#include <algorithm>
#include <limits>

#include "io/error.hpp"
#include "io/file_bytes.hpp"
#include "io/mesh/mesh_formats.hpp"
#include "numerics/floating_point_state.hpp"

namespace tamis::io {
namespace {

/// Without the mark that editors put before a text in UTF-8.
std::string_view without_mark(std::string_view bytes) {
  constexpr std::string_view kMark = "\xef\xbb\xbf";
  return bytes.starts_with(kMark) ? bytes.substr(kMark.size()) : bytes;
}

MeshFile parse(const FileBytes& file, const std::filesystem::path& path) {
  const std::string name = path.string();
  const std::string_view bytes = without_mark(file.view());
  if (bytes.empty()) throw FileError(name, "", fmt::format("the file is empty: give a {} file", mesh_format_names()));
  if (const MeshFormat* format = mesh_format_of(bytes, path)) return format->parse(bytes, name);
  throw FileError(name, "",
                  fmt::format("not {}: convert it to such a file, or let its name end as that of its format; "
                              "tamis.audit in Python reads USD and glTF",
                              mesh_format_names()));
}

/// Two files under comparison.
struct Names {
  const std::string& first;
  const std::string& second;
};

void require_same_count(std::size_t first, std::size_t second, const Names& names, const char* what) {
  if (first == second) return;
  throw FileError(names.second, "",
                  fmt::format("{} {}, but {} has {}: give frames of one mesh", second, what, names.first, first));
}

template <class T>
void require_same(const std::vector<T>& first, const std::vector<T>& second, const Names& names, const char* what) {
  require_same_count(first.size(), second.size(), names, fmt::format("{}s", what).c_str());
  const auto [a, b] = std::mismatch(first.begin(), first.end(), second.begin());
  if (a != first.end())
    throw FileError(names.second, fmt::format("{} {}", what, b - second.begin()),
                    fmt::format("it joins other vertices than in {}: give frames of one mesh", names.first));
}

}  // namespace

MeshFile read_mesh(const std::filesystem::path& path) {
  const ComputingState state;
  MeshFile mesh = parse(FileBytes(path), path);
  if (mesh.positions.empty()) throw FileError(path.string(), "", "no vertex in it: give a mesh");
  if (mesh.positions.size() > static_cast<std::size_t>(std::numeric_limits<Index>::max()))
    throw FileError(path.string(), "", "more vertices than 32-bit indices can name: give a smaller mesh");
  if (mesh.faces.empty() && mesh.loose_edges.empty() && mesh.loose_points.empty())
    throw FileError(path.string(), "", "no face and no edge in it: give a mesh, not a bare set of points");
  return mesh;
}

void note_open_end(std::string_view text, MeshFile& mesh) {
  if (!text.ends_with('\n') && !text.ends_with('\r'))
    mesh.notes.emplace_back("the last line has no line end: was the file cut short?");
}

Mesh mesh_of(MeshFile file) {
  return Mesh(static_cast<Index>(file.positions.size()), std::move(file.faces), file.loose_edges,
              std::move(file.loose_points));
}

bool has_topology_of(const MeshFile& first, const MeshFile& second) {
  return first.faces == second.faces && first.loose_edges == second.loose_edges &&
         first.loose_points == second.loose_points;
}

void require_same_mesh(const MeshFile& first, const std::string& first_name, const MeshFile& second,
                       const std::string& second_name) {
  const Names names{first_name, second_name};
  require_same_count(first.positions.size(), second.positions.size(), names, "vertices");
  require_same(first.faces, second.faces, names, "triangle");
  require_same(first.loose_edges, second.loose_edges, names, "loose edge");
  require_same(first.loose_points, second.loose_points, names, "loose point");
}

}  // namespace tamis::io

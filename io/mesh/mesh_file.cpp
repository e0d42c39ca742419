#include "io/mesh/mesh_file.hpp"

#include <algorithm>
#include <limits>

#include "io/error.hpp"
#include "io/extension.hpp"
#include "io/file_bytes.hpp"
#include "io/mesh/obj.hpp"
#include "io/mesh/ply.hpp"

namespace tamis::io {
namespace {

MeshFile parse(const FileBytes& bytes, const std::filesystem::path& path) {
  const std::string name = path.string();
  if (bytes.view().empty()) throw FileError(name, "", "the file is empty: give a PLY or OBJ file");
  if (looks_like_ply(bytes.view())) return parse_ply(bytes.view(), name);
  const std::string extension = extension_of(path);
  if (extension == ".obj") return parse_obj(bytes.view(), name);
  if (extension == ".ply") throw FileError(name, "line 1", "a PLY file starts with the line 'ply': write it again");
  throw FileError(name, "",
                  "neither PLY nor OBJ: convert it to one of these, or let the name of an OBJ file end in .obj; "
                  "tamis.audit in Python reads USD and glTF");
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
  MeshFile mesh = parse(FileBytes(path), path);
  if (mesh.positions.empty()) throw FileError(path.string(), "", "no vertex in it: give a mesh");
  if (mesh.positions.size() > static_cast<std::size_t>(std::numeric_limits<Index>::max()))
    throw FileError(path.string(), "", "more vertices than 32-bit indices can name: give a smaller mesh");
  if (mesh.faces.empty() && mesh.loose_edges.empty() && mesh.loose_points.empty())
    throw FileError(path.string(), "", "no face and no edge in it: give a mesh, not a bare set of points");
  return mesh;
}

bool is_mesh_name(const std::filesystem::path& path) {
  const std::string extension = extension_of(path);
  return extension == ".ply" || extension == ".obj";
}

void note_open_end(std::string_view text, MeshFile& mesh) {
  if (!text.ends_with('\n')) mesh.notes.emplace_back("the last line has no line end: was the file cut short?");
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

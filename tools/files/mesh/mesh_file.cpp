#include "files/mesh/mesh_file.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <limits>

#include "files/error.hpp"
#include "files/extension.hpp"
#include "files/file_bytes.hpp"
#include "files/mesh/mesh_formats.hpp"
#include "files/system.hpp"
#include "files/text.hpp"
#include "numbers/floating_point_state.hpp"

namespace tamis::io {
namespace {

/// Without the mark that editors put before a text in UTF-8.
std::string_view without_mark(std::string_view bytes) {
  constexpr std::string_view kMark = "\xef\xbb\xbf";
  return bytes.starts_with(kMark) ? bytes.substr(kMark.size()) : bytes;
}

/// What to do with files of other formats, by their extensions.
struct OtherFormat {
  std::string_view extensions;
  std::string_view advice;
};

constexpr std::array<OtherFormat, 5> kOtherFormats{
    {{".usd .usda .usdc .usdz .gltf .glb .npz", "tamis.audit in Python reads it"},
     {".abc",
      "Alembic is not read: export USD for tamis.audit in Python, or a mesh file with a point cache (.pc2, .mdd)"},
     {".pc2 .mdd", "a point cache has no faces: 'tamis audit MESH CACHE' reads it together with a mesh file"},
     {".vtk .vtu .vtp .msh .fbx .dae .3ds .3mf .blend .stp .step .igs .iges .x3d .wrl .ply2 .mesh", "convert it"},
     {".csv .json .html", "this is not a mesh: 'tamis bodies' reads JSON, the others are written by tamis"}}};

std::string advice_on(const std::filesystem::path& path) {
  const std::string extension = extension_of(path);
  for (const OtherFormat& format : kOtherFormats) {
    std::string_view rest = format.extensions;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest))
      if (word == extension) return std::string(format.advice);
  }
  return "convert it, or give its name the ending of its format";
}

/// Text of 16-bit characters has a mark before it, or a zero byte beside each letter.
bool is_utf16(std::string_view bytes) {
  using namespace std::literals;
  return bytes.starts_with("\xff\xfe"sv) || bytes.starts_with("\xfe\xff"sv) ||
         (bytes.size() > 3 && ((bytes[0] == 0) != (bytes[1] == 0)) && (bytes[0] == 0) == (bytes[2] == 0) &&
          (bytes[1] == 0) == (bytes[3] == 0));
}

MeshFile parse(const FileBytes& file, const std::filesystem::path& path) {
  const std::string name = path.string();
  const std::string_view bytes = without_mark(file.view());
  if (bytes.empty()) throw FileError(name, "", fmt::format("the file is empty: give a {} file", mesh_format_names()));
  const MeshFormat* format = mesh_format_of(bytes, path);
  if (!format) throw FileError(name, "", fmt::format("not {}: {}", mesh_format_names(), advice_on(path)));
  if (is_utf16(bytes) && format->extension != ".stl")
    throw FileError(name, "", "a text in UTF-16: save it as UTF-8 or ASCII");
  return format->parse(bytes, name);
}

constexpr const char* kStlFrames =
    " (STL has no vertex numbers: corners at one place are one vertex; PLY, OBJ and OFF keep vertices apart)";

/// Two files under comparison.
struct Names {
  const std::string& first;
  const std::string& second;
};

void require_same_count(std::size_t first, std::size_t second, const Names& names, const char* what) {
  if (first == second) return;
  throw FileError(names.second, "",
                  fmt::format("{} {}, but {} has {}: give frames of one mesh{}", second, what, names.first, first,
                              extension_of(system::path_of(names.second)) == ".stl" ? kStlFrames : ""));
}

/// Faces or loose edges of one size each, or of the sizes that `counts` lists.
struct Rows {
  std::span<const Index> vertices;
  std::span<const Index> counts;
  std::size_t size = 0;  ///< where there are no `counts`

  std::size_t count() const { return counts.empty() ? vertices.size() / size : counts.size(); }
};

template <class T>
Rows rows_of(const std::vector<T>& rows) {
  return {{rows.empty() ? nullptr : rows.front().data(), rows.size() * std::tuple_size_v<T>}, {}, std::tuple_size_v<T>};
}

/// As the file lists them, unless only one of both files has polygons.
Rows faces_of(const MeshFile& file, const MeshFile& other) {
  if (file.corner_counts.empty() || other.corner_counts.empty()) return rows_of(file.faces);
  return {file.corners, file.corner_counts};
}

/// Has the second list the vertices of the first in the same cyclic order?
bool is_turned(std::span<const Index> first, std::span<const Index> second) {
  if (std::ranges::equal(first, second)) return true;
  for (std::size_t turn = 1; turn < first.size(); ++turn)
    if (std::equal(first.begin() + static_cast<std::ptrdiff_t>(turn), first.end(), second.begin()) &&
        std::equal(first.begin(), first.begin() + static_cast<std::ptrdiff_t>(turn),
                   second.end() - static_cast<std::ptrdiff_t>(turn)))
      return true;
  return false;
}

enum class Difference { none, order, vertices };

struct FirstDifference {
  std::size_t row = 0;
  Difference what = Difference::none;
};

Difference difference_of(std::span<const Index> first, std::span<const Index> second) {
  if (first.size() == second.size() && is_turned(first, second)) return Difference::none;
  return std::ranges::is_permutation(first, second) ? Difference::order : Difference::vertices;
}

/// REQUIRES: as many rows in both.
FirstDifference first_difference(const Rows& first, const Rows& second) {
  std::span<const Index> a = first.vertices, b = second.vertices;
  for (std::size_t row = 0; row < first.count(); ++row) {
    const auto take = [row](std::span<const Index>& left, const Rows& rows) {
      const std::size_t size = rows.counts.empty() ? rows.size : static_cast<std::size_t>(rows.counts[row]);
      const std::span<const Index> taken = left.first(size);
      left = left.subspan(size);
      return taken;
    };
    const Difference what = difference_of(take(a, first), take(b, second));
    if (what != Difference::none) return {row, what};
  }
  return {};
}

bool are_same(const Rows& first, const Rows& second) {
  return first.count() == second.count() && first_difference(first, second).what == Difference::none;
}

void require_same(const Rows& first, const Rows& second, const Names& names, const char* what) {
  require_same_count(first.count(), second.count(), names, fmt::format("{}s", what).c_str());
  const auto [row, difference] = first_difference(first, second);
  if (difference == Difference::none) return;
  throw FileError(
      names.second, fmt::format("{} {}", what, row),
      difference == Difference::order
          ? fmt::format("it lists its vertices in another order than in {}: give frames of one mesh", names.first)
          : fmt::format("it joins other vertices than in {}: give frames of one mesh", names.first));
}

/// " (element 'range_grid' was skipped)"; empty if nothing is noted.
std::string skipped_in(const MeshFile& mesh) {
  return mesh.notes.empty() ? "" : fmt::format(" ({})", fmt::join(mesh.notes, "; "));
}

}  // namespace

MeshFile read_mesh(const std::filesystem::path& path) {
  const ComputingState state;
  MeshFile mesh = parse(FileBytes(path), path);
  if (mesh.positions.empty()) throw FileError(path.string(), "", "no vertex in it: give a mesh");
  if (mesh.positions.size() > static_cast<std::size_t>(std::numeric_limits<Index>::max()))
    throw FileError(path.string(), "", "more vertices than 32-bit indices can name: give a smaller mesh");
  if (mesh.faces.empty() && mesh.loose_edges.empty() && mesh.loose_points.empty())
    throw FileError(path.string(), "",
                    "no face and no edge in it" + skipped_in(mesh) + ": give a mesh, not a bare set of points");
  return mesh;
}

Mesh mesh_of(MeshFile file) {
  return Mesh(static_cast<Index>(file.positions.size()), std::move(file.faces), file.loose_edges,
              std::move(file.loose_points));
}

bool has_topology_of(const MeshFile& first, const MeshFile& second) {
  return first.positions.size() == second.positions.size() &&
         are_same(faces_of(first, second), faces_of(second, first)) &&
         are_same(rows_of(first.loose_edges), rows_of(second.loose_edges)) && first.loose_points == second.loose_points;
}

void require_same_mesh(const MeshFile& first, const std::string& first_name, const MeshFile& second,
                       const std::string& second_name) {
  const Names names{first_name, second_name};
  require_same_count(first.positions.size(), second.positions.size(), names, "vertices");
  const bool has_polygons = !first.corner_counts.empty() && !second.corner_counts.empty();
  require_same(faces_of(first, second), faces_of(second, first), names, has_polygons ? "polygon" : "triangle");
  require_same(rows_of(first.loose_edges), rows_of(second.loose_edges), names, "loose edge");
  require_same({first.loose_points, {}, 1}, {second.loose_points, {}, 1}, names, "loose point");
}

}  // namespace tamis::io

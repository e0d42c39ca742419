#include "files/mesh/mesh_formats.hpp"

#include <algorithm>
#include <array>

#include "files/extension.hpp"
#include "files/mesh/obj.hpp"
#include "files/mesh/off.hpp"
#include "files/mesh/ply.hpp"
#include "files/mesh/stl.hpp"

namespace tamis::io {
namespace {

constexpr std::array kMeshFormats{
    MeshFormat{"PLY", ".ply", looks_like_ply, parse_ply}, MeshFormat{"OBJ", ".obj", nullptr, parse_obj},
    MeshFormat{"STL", ".stl", looks_like_stl, parse_stl}, MeshFormat{"OFF", ".off", looks_like_off, parse_off}};

const MeshFormat* mesh_format_named(const std::filesystem::path& path) {
  const auto found = std::ranges::find(kMeshFormats, extension_of(path), &MeshFormat::extension);
  return found == kMeshFormats.end() ? nullptr : &*found;
}

}  // namespace

std::span<const MeshFormat> mesh_formats() { return kMeshFormats; }

const MeshFormat* mesh_format_of(std::string_view bytes, const std::filesystem::path& path) {
  for (const MeshFormat& format : kMeshFormats)
    if (format.looks_like && format.looks_like(bytes)) return &format;
  return mesh_format_named(path);
}

bool is_mesh_name(const std::filesystem::path& path) { return mesh_format_named(path) != nullptr; }

std::string mesh_format_names() {
  std::string names;
  for (const MeshFormat& format : kMeshFormats) {
    if (!names.empty()) names += &format == &kMeshFormats.back() ? " or " : ", ";
    names += format.name;
  }
  return names;
}

}  // namespace tamis::io

// The formats in which meshes are read. Each stands once: in the list of mesh_formats.cpp.
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "files/mesh/mesh_file.hpp"

namespace tamis::io {

struct MeshFormat {
  std::string_view name;                       ///< for people, as in "PLY"
  std::string_view extension;                  ///< in small letters, as in ".ply"
  bool (*looks_like)(std::string_view bytes);  ///< null: files of this format are known by their extension alone
  /// `name` stands for the file in messages. Throws FileError.
  MeshFile (*parse)(std::string_view bytes, const std::string& name);
};

std::span<const MeshFormat> mesh_formats();

/// The format that the content tells, or else the extension; null if neither does.
const MeshFormat* mesh_format_of(std::string_view bytes, const std::filesystem::path& path);

/// Does the name end as those of mesh files do?
bool is_mesh_name(const std::filesystem::path& path);

/// Their names for help and messages: "PLY or OBJ".
std::string mesh_format_names();

}  // namespace tamis::io

// PLY: ascii, binary little-endian and binary big-endian, every scalar type; doubles in, doubles out.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "io/mesh_file.hpp"

namespace tamis::io {

bool looks_like_ply(std::string_view bytes);

/// Elements: vertex (x, y, z), face (vertex_indices or vertex_index) and edge (vertex1, vertex2: loose edges). Other
/// properties are skipped, other elements too, with a note. `name` stands for the file in messages. Throws FileError.
MeshFile parse_ply(std::string_view bytes, const std::string& name);

/// Binary, doubles, atomically: the file is either complete or as it was. Loose points have no place in PLY and are
/// written as vertices only. Throws FileError.
void write_ply(const std::filesystem::path& path, const MeshFile& mesh);

}  // namespace tamis::io

// PLY: ascii, binary little-endian and binary big-endian, every scalar type; doubles in, doubles out.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "files/mesh/mesh_file.hpp"

namespace tamis::io {

bool looks_like_ply(std::string_view bytes);

/// Elements: vertex (x, y, z), face (vertex_indices or vertex_index), tristrips (vertex_indices), edge (vertex1,
/// vertex2: loose edges) and point (vertex: loose points; our own, as PLY has none). Other properties are skipped,
/// other elements too, with a note. `name` stands for the file in messages. Throws FileError.
MeshFile parse_ply(std::string_view bytes, const std::string& name);

/// Binary, doubles, atomically: the file is either complete or as it was. Throws FileError.
void write_ply(const std::filesystem::path& path, const MeshFile& mesh);

}  // namespace tamis::io

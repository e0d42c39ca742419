// STL: ascii and binary triangles without vertex numbers.
#pragma once
#include <string>
#include <string_view>

#include "files/mesh/mesh_file.hpp"

namespace tamis::io {

/// Knows ascii files alone: nothing marks binary ones.
bool looks_like_stl(std::string_view bytes);

/// Corners at the same place become one vertex, in the order in which they come. `name` stands for the file in
/// messages. Throws FileError.
MeshFile parse_stl(std::string_view bytes, const std::string& name);

}  // namespace tamis::io

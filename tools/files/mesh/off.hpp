// OFF: the text format of Geomview.
#pragma once
#include <string>
#include <string_view>

#include "files/mesh/mesh_file.hpp"

namespace tamis::io {

bool looks_like_off(std::string_view bytes);

/// Faces with two corners give loose edges, with one loose points. Colours, normals and textures are passed over.
/// `name` stands for the file in messages. Throws FileError.
MeshFile parse_off(std::string_view bytes, const std::string& name);

}  // namespace tamis::io

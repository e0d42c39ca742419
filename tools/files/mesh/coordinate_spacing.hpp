// Are the coordinates of a mesh file finer than its edges?
#pragma once
#include <string>

#include "files/mesh/mesh_file.hpp"

namespace tamis::io {

/// A sentence if some edge is shorter than ten times the distance between neighbouring numbers of the stored type at
/// its ends; otherwise empty. Edges of length zero do not count.
std::string note_on_spacing(const MeshFile& mesh);

}  // namespace tamis::io

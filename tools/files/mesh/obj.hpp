// Wavefront OBJ: v, f, l and p; everything else about a surface is passed over.
#pragma once
#include <string>
#include <string_view>

#include "files/mesh/mesh_file.hpp"

namespace tamis::io {

/// Corners as v, v/vt, v//vn or v/vt/vn; negative indices count back from the last vertex. Polygons are cut into
/// triangles; `l` gives loose edges, `p` loose points. Lines with unknown words are skipped, with a note. `name` stands
/// for the file in messages. Throws FileError.
MeshFile parse_obj(std::string_view bytes, const std::string& name);

}  // namespace tamis::io

// Reads a block of the rows of a PLY file without the rest.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis::distributed {

/// One of `count` parts of equal size.
struct Block {
  std::uint64_t part, count;

  std::uint64_t first_of(std::uint64_t rows) const { return rows * part / count; }
  std::uint64_t last_of(std::uint64_t rows) const { return rows * (part + 1) / count; }
};

struct PlyPart {
  std::uint64_t vertices = 0, faces = 0;  ///< of the whole file
  std::vector<Point> positions;
  std::vector<Face> triangles;
};

/// Returns none unless this is a binary PLY file of vertices and triangles alone, without any error. Then read the
/// whole file by the ordinary reader, which says what is wrong.
std::optional<PlyPart> read_ply_part(const std::string& path, const Block& block);

}  // namespace tamis::distributed

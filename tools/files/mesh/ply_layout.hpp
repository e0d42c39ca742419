// What a PLY element means, and where each of its properties goes.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "files/mesh/ply_header.hpp"

namespace tamis::io {

enum class ElementKind : std::uint8_t { vertex, face, strip, edge, point, other };

ElementKind kind_of(const PlyElement& element);

/// Where a property goes: a place in the row (x, y, z; vertex1, vertex2; vertex), the corners of a polygon, or nowhere.
inline constexpr int kSkipped = -1;
inline constexpr int kCorners = 3;

/// The place of each property. Throws FileError if a property without which the element means nothing is absent or
/// stands twice.
std::vector<int> places_of(const PlyElement& element, const std::string& name);

}  // namespace tamis::io

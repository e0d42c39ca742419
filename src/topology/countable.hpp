// How large a mesh may be.
#pragma once
#include <limits>
#include <string>

#include "numerics/assert.hpp"
#include "tamis/error.hpp"
#include "tamis/mesh.hpp"

namespace tamis {

/// Edges, and the rows of faces by vertex and by edge, are numbered by Index: three sides a face and the loose edges
/// must have a number each. Throws InvalidMesh if they have not.
inline void require_countable(std::size_t faces, std::size_t loose_edges) {
  constexpr auto kMostEdges = static_cast<std::size_t>(std::numeric_limits<Index>::max());
  if (loose_edges <= kMostEdges && faces <= (kMostEdges - loose_edges) / 3) return;
  throw InvalidMesh("the mesh has " + std::to_string(faces) + " faces and " + std::to_string(loose_edges) +
                    " loose edges: three sides a face and the loose edges together may be " +
                    std::to_string(kMostEdges) + " at most; split the mesh");
}

/// The number of an edge, or of an item of a row, by how many come before it. REQUIRES: a mesh that is countable, so
/// that it has one.
inline Index number_of(std::size_t before) {
  TAMIS_ASSERT(before <= static_cast<std::size_t>(std::numeric_limits<Index>::max()));
  return static_cast<Index>(before);
}

}  // namespace tamis

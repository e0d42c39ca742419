// Limits of size: how much of a mesh, and of an answer about it, 32-bit indices can number.
#pragma once
#include <limits>
#include <string>

#include "numbers/assert.hpp"
#include "tamis/error.hpp"
#include "tamis/mesh.hpp"

namespace tamis {

/// The largest number of an Index.
inline constexpr auto kMostNumbers = static_cast<std::size_t>(std::numeric_limits<Index>::max());

/// Edges, and the rows of faces by vertex and by edge, are numbered by Index. Three sides a face and the loose edges
/// must have a number each. Throws InvalidMesh if they have not.
inline void require_countable(std::size_t faces, std::size_t loose_edges) {
  if (loose_edges <= kMostNumbers && faces <= (kMostNumbers - loose_edges) / 3) return;
  throw InvalidMesh("the mesh has " + std::to_string(faces) + " faces and " + std::to_string(loose_edges) +
                    " loose edges: three sides a face and the loose edges together may be " +
                    std::to_string(kMostNumbers) + " at most; split the mesh");
}

/// Throws InvalidMesh unless both ends of all edges can be numbered by Index. Rows of neighbours hold them all.
inline void require_countable_ends(std::size_t edges) {
  if (edges <= kMostNumbers / 2) return;
  throw InvalidMesh("the mesh has " + std::to_string(edges) +
                    " edges: for questions about neighbours, such as rings, " + std::to_string(kMostNumbers / 2) +
                    " may be at most; split the mesh");
}

/// The pairs of an answer are numbered in 32 bits while they are put in order. Throws Error if there are more.
inline void require_countable_pairs(std::size_t pairs) {
  if (pairs <= kMostNumbers) return;
  throw Error("the answer has more than " + std::to_string(kMostNumbers) +
              " pairs: query parts of the mesh, or take a smaller distance");
}

/// The number of an edge, given how many come before it. REQUIRES: a countable mesh, so the edge has a number.
inline Index number_of(std::size_t before) {
  TAMIS_ASSERT(before <= kMostNumbers);
  return static_cast<Index>(before);
}

}  // namespace tamis

// Facts about a mesh for its user: counts of features, and the box.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "files/extent.hpp"
#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis::cli {

struct MeshFacts {
  std::size_t rods = 0;                 ///< edges of no triangle
  std::size_t boundary_edges = 0;       ///< of one triangle
  std::size_t non_manifold_edges = 0;   ///< of three or more
  std::size_t loose_points = 0;         ///< of no triangle and no edge, but listed as points
  std::size_t unused_vertices = 0;      ///< they take no part in contacts
  std::size_t not_finite_vertices = 0;  ///< unused ones with a coordinate that is NaN or infinite
  std::size_t coincident_vertices = 0;  ///< used ones that lie exactly on another one
  std::size_t flat_folds = 0;           ///< edges at which two triangles lie on each other, but for duplicates
  std::size_t degenerate_faces = 0;     ///< of area exactly zero
  std::size_t duplicate_faces = 0;      ///< triangles that repeat the vertices of another one
  std::size_t components = 0;           ///< connected by common vertices; unused vertices do not count
  io::Box box;                          ///< around the used vertices
};

/// "(0, 0, 0) to (1, 1, 1)", with as many digits as tell both corners apart.
std::string text_of(const io::Box& box);

MeshFacts facts_of(const Mesh& mesh, const std::vector<Point>& positions);

}  // namespace tamis::cli

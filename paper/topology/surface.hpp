// The mesh as the triangle hierarchy needs it: every feature belongs to some triangle.
#pragma once
#include <optional>

#include "tamis/mesh.hpp"

namespace tamis::lab {

/// The mesh itself, or a copy with degenerate triangles added: (a, b, b) for each rod, (p, p, p) for each loose point.
/// Edges, points and the first `face_count` faces are numbered as in the mesh; only those faces are features.
class Surface {
 public:
  /// The mesh must outlive it.
  explicit Surface(const Mesh& mesh);

  const Mesh& mesh() const { return completed_ ? *completed_ : original_; }
  Index face_count() const { return static_cast<Index>(original_.faces().size()); }

 private:
  const Mesh& original_;
  std::optional<Mesh> completed_;
};

}  // namespace tamis::lab

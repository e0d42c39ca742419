// Joins vertices that lie at one place: exporters that keep normals or textures list a vertex once for each.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "files/mesh/mesh_file.hpp"

namespace tamis::io {

/// Which vertices are joined, over all frames that were added: two that part in some frame are not. Vertices keep their
/// numbers; those that are joined to an earlier one belong to nothing any more.
class Weld {
 public:
  /// Vertices are joined if they lie within `distance` of the first of them; 0: exactly at one place.
  explicit Weld(std::size_t vertex_count, double distance = 0);

  /// REQUIRES: a position for each vertex.
  void add_frame(std::span<const Point> positions);

  /// For each vertex the first one of those with which it is joined, perhaps itself.
  const std::vector<Index>& first_of_vertex() const { return first_; }
  std::size_t joined_count() const;
  /// Lets the features of a mesh name the first vertex in place of those joined to it.
  void apply_to(MeshFile& file) const;
  Mesh welded(const Mesh& mesh) const;

 private:
  double distance_;
  std::vector<Index> first_;
};

}  // namespace tamis::io

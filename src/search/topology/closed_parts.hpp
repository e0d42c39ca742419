// Which parts of a mesh are closed, so that they have an inside.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "numbers/held_bytes.hpp"
#include "tamis/contact.hpp"
#include "tamis/mesh.hpp"

namespace tamis {

/// The parts of a mesh are its connected components. Along open edges vertices at one place count as one vertex: files
/// often split vertices along seams. A part is closed if each of its edges has an even number of faces. Then the number
/// of faces that a ray from a point crosses is even for all rays, or odd for all. If the faces at each edge also go
/// around in both directions equally often, the part has a winding number.
struct ClosedParts {
  static constexpr Index kOpen = -1, kWound = 0;

  /// REQUIRES (not checked: O(n)): one point a vertex, finite where the vertex is in use.
  ClosedParts(const Mesh& mesh, std::span<const Point> points);

  /// True if all faces are in closed parts, and there is a face.
  bool is_closed() const { return is_closed_; }
  /// True if a face is in a closed part.
  bool encloses() const { return encloses_; }
  /// For each face kOpen, kWound for all parts with a winding number, or the number >= 1 of another closed part. A face
  /// with two vertices at one place is kOpen: it encloses nothing.
  std::vector<Index> part_of_face;
  Index count = 1;                          ///< one more than the largest number
  std::vector<Index> one_vertex_of_each;    ///< of each connected part, with or without faces
  std::vector<std::array<Index, 2>> seams;  ///< pairs of vertices that were joined

  std::uint64_t memory_bytes() const { return held_bytes(part_of_face, one_vertex_of_each, seams); }

 private:
  bool is_closed_ = false, encloses_ = false;
};

}  // namespace tamis

// The topology of the moving objects: made once, shared by every step.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tamis {

using Index = std::int32_t;
using Face = std::array<Index, 3>;  ///< vertex indices, in the caller's winding
using Edge = std::array<Index, 2>;  ///< vertex indices, ascending

/// Compressed rows: row i is `items[offsets[i] .. offsets[i+1])`.
struct IndexRows {
  std::vector<Index> offsets{0};
  std::vector<Index> items;

  std::span<const Index> operator[](Index row) const {
    const auto first = static_cast<std::size_t>(offsets[static_cast<std::size_t>(row)]);
    const auto last = static_cast<std::size_t>(offsets[static_cast<std::size_t>(row) + 1]);
    return std::span(items).subspan(first, last - first);
  }
  Index size() const { return static_cast<Index>(offsets.size()) - 1; }
};

/// Triangles, plus optional loose edges (rods) and loose points. Legal: any winding; open and non-manifold meshes;
/// duplicate and degenerate triangles; vertices that nothing uses (they take no part in contacts). A triangle that
/// names one vertex three times counts as a loose point, too.
class Mesh {
 public:
  /// `vertex_count`: number of rows of the positions of every step, >= 0.
  /// Throws InvalidMesh if an index lies outside [0, vertex_count), if there is no feature at all, or if three times
  /// the faces plus the loose edges are more than 2^31 - 1.
  Mesh(Index vertex_count, std::vector<Face> faces, const std::vector<Edge>& loose_edges = {},
       std::vector<Index> loose_points = {});

  Index vertex_count() const { return vertex_count_; }
  /// The triangles as given.
  std::span<const Face> faces() const { return faces_; }
  /// Every edge of a triangle and every loose edge, once; vertices ascending; sorted. An edge whose two indices are
  /// equal is left out, but its vertex is a point.
  std::span<const Edge> edges() const { return edges_; }
  /// The vertices that take part in contacts: used by a face or an edge, or loose; ascending.
  std::span<const Index> points() const { return points_; }

  /// All triangles incident to an edge, which is given by its place in edges(): none for a rod, one for a border edge,
  /// two within a manifold, any number otherwise.
  std::span<const Index> faces_of_edge(Index edge) const { return faces_of_edge_[edge]; }
  /// All triangles incident to a vertex.
  std::span<const Index> faces_of_vertex(Index vertex) const { return faces_of_vertex_[vertex]; }
  /// The edges of a triangle in the order (v0 v1), (v1 v2), (v2 v0); -1 where the two indices are equal.
  std::array<Index, 3> edges_of_face(Index face) const { return edges_of_face_[static_cast<std::size_t>(face)]; }

  /// The place in edges() of the edge between two vertices, in either order; -1 if there is none. Time: logarithmic.
  Index find_edge(Index a, Index b) const;
  /// The place in faces() of the first triangle with these indices in this order; -1 if there is none. Time: linear in
  /// the number of triangles of its first vertex.
  Index find_face(const Face& face) const;

 private:
  Index vertex_count_;
  std::vector<Face> faces_;
  std::vector<Edge> edges_;
  std::vector<Index> points_;
  IndexRows faces_of_edge_;
  IndexRows faces_of_vertex_;
  std::vector<std::array<Index, 3>> edges_of_face_;
};

}  // namespace tamis

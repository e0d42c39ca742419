// The topology of the moving objects: made once, shared by every step.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tamis {

using Index = std::int32_t;         ///< the number of a vertex, an edge, a face or a body
using Face = std::array<Index, 3>;  ///< vertex indices, in the caller's winding
using Edge = std::array<Index, 2>;  ///< vertex indices, ascending

/// A matrix or an expression of any kind.
template <class M>
concept MatrixLike = requires(const M& m) {
  m.rows();
  m.cols();
};

/// Triangles, plus optional loose edges (rods) and loose points. Legal are any winding, open and non-manifold meshes,
/// duplicate and degenerate triangles, and unused vertices (they take no part in contacts). A triangle that names one
/// vertex three times counts as a loose point, too.
class Mesh {
 public:
  /// Takes the topology. `vertex_count`: number of rows of the positions of every step, >= 0.
  /// Throws InvalidMesh if an index lies outside [0, vertex_count), or if the mesh has no feature. It also throws if
  /// three times the faces plus the loose edges are more than 2^31 - 1.
  Mesh(Index vertex_count, std::vector<Face> faces, const std::vector<Edge>& loose_edges = {},
       std::vector<Index> loose_points = {});
  // Compilers show the line of the deleted constructor: its comment says what to do.
  // clang-format off
  template <MatrixLike M, class... Others>
  Mesh(Index, const M&, const Others&...) = delete;  // A matrix? tamis::faces_of(matrix).
  template <MatrixLike M, class... Others>
  Mesh(Index, const std::vector<Face>&, const M&, const Others&...) = delete;  // A matrix? tamis::edges_of(matrix).
  // clang-format on

  /// Returns the number of rows of the positions of every step.
  [[nodiscard]] Index vertex_count() const { return vertex_count_; }
  /// Returns the triangles as given.
  [[nodiscard]] std::span<const Face> faces() const { return faces_; }
  /// Returns every edge of a triangle and every loose edge, once; vertices ascending; sorted. An edge whose two indices
  /// are equal is skipped. Its vertex is a point.
  [[nodiscard]] std::span<const Edge> edges() const { return edges_; }
  /// Returns the vertices that take part in contacts: used by a face or an edge, or loose; ascending.
  [[nodiscard]] std::span<const Index> points() const { return points_; }

  /// Returns all triangles incident to an edge. The edge is given by its place in edges(). There are none for a rod,
  /// one for a border edge, two within a manifold, any number otherwise.
  [[nodiscard]] std::span<const Index> faces_of_edge(Index edge) const {
    return row_of(faces_of_edges_, first_face_of_edge_, edge);
  }
  /// Returns all triangles incident to a vertex.
  [[nodiscard]] std::span<const Index> faces_of_vertex(Index vertex) const {
    return row_of(faces_of_vertices_, first_face_of_vertex_, vertex);
  }
  /// Returns the edges of a triangle in the order (v0 v1), (v1 v2), (v2 v0); -1 where the two indices are equal.
  [[nodiscard]] std::array<Index, 3> edges_of_face(Index face) const {
    return edges_of_face_[static_cast<std::size_t>(face)];
  }

  /// Returns the place in edges() of the edge between two vertices, in either order; -1 if there is none. Time:
  /// logarithmic.
  [[nodiscard]] Index find_edge(Index a, Index b) const;
  /// Returns the place in faces() of the first triangle with these indices in this order; -1 if there is none. Time:
  /// linear in the number of triangles of its first vertex.
  [[nodiscard]] Index find_face(const Face& face) const;

 private:
  /// Returns row i of compressed rows: `items[firsts[i] .. firsts[i+1])`.
  static std::span<const Index> row_of(const std::vector<Index>& items, const std::vector<Index>& firsts, Index i) {
    const auto row = static_cast<std::size_t>(i), first = static_cast<std::size_t>(firsts[row]);
    return std::span(items).subspan(first, static_cast<std::size_t>(firsts[row + 1]) - first);
  }

  Index vertex_count_;
  std::vector<Face> faces_;
  std::vector<Edge> edges_;
  std::vector<Index> points_;
  std::vector<Index> faces_of_edges_, first_face_of_edge_;
  std::vector<Index> faces_of_vertices_, first_face_of_vertex_;
  std::vector<std::array<Index, 3>> edges_of_face_;
};

}  // namespace tamis

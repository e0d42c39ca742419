// Kinds of pairs differ in the vertices that make their vectors. Everything else follows from the three vectors of
// PairMotion (pair/motion/pair_motion.hpp).
#pragma once
#include <cstddef>
#include <span>
#include <type_traits>

#include "numbers/assert.hpp"
#include "tamis/contact.hpp"

namespace tamis {

constexpr bool is_kind(PairKind kind) { return static_cast<std::size_t>(kind) < kPairKinds; }

/// A difference of two of the pair's vertices.
struct VertexDifference {
  std::size_t to, from;
};

/// The vectors of PairMotion. A side that a feature lacks is the difference of a vertex and itself. So it is exactly
/// zero.
struct SpanningVectors {
  VertexDifference e, f, d;
};

/// Vertices as in Contact.
constexpr SpanningVectors spanning_vectors(PairKind kind) {
  switch (kind) {
    case PairKind::vertex_face:
      return {{2, 1}, {3, 1}, {0, 1}};
    case PairKind::edge_edge:
      return {{1, 0}, {3, 2}, {2, 0}};
    case PairKind::vertex_edge:
      return {{2, 1}, {1, 1}, {0, 1}};
    case PairKind::vertex_vertex:
      break;
  }
  return {{1, 1}, {1, 1}, {0, 1}};
}

/// Vertex-face and edge-edge meet by passing through each other, when their four vertices are coplanar. The others have
/// no inside to pass through. They meet at single times, which hardly ever happens, or come near.
constexpr bool can_cross(PairKind kind) { return kind == PairKind::vertex_face || kind == PairKind::edge_edge; }

/// True if contact is a matter of the distance. If not, it is a matter of when the four points are coplanar.
constexpr bool is_about_distance(PairKind kind, double separation) { return separation > 0 || !can_cross(kind); }

/// The index, among the pair's vertices, of the second feature's first vertex.
constexpr std::size_t second_feature(PairKind kind) { return kind == PairKind::edge_edge ? 2 : 1; }

constexpr std::size_t vertex_count(PairKind kind) {
  switch (kind) {
    case PairKind::vertex_vertex:
      return 2;
    case PairKind::vertex_edge:
      return 3;
    case PairKind::vertex_face:
    case PairKind::edge_edge:
      break;
  }
  return 4;
}

inline constexpr VertexDifference kVertexCorners[] = {{0, 1}, {0, 2}, {0, 3}};
inline constexpr VertexDifference kEdgeCorners[] = {{2, 0}, {2, 1}, {3, 1}, {3, 0}};

/// The corners of the Minkowski difference of the two features, in order around it.
constexpr std::span<const VertexDifference> difference_corners(PairKind kind) {
  if (kind == PairKind::edge_edge) return kEdgeCorners;
  return std::span(kVertexCorners).first(vertex_count(kind) - 1);
}

/// Calls f(kind) with the kind as a constant. In f, `kind()` can be a template argument. REQUIRES: a valid kind.
template <class F>
decltype(auto) with_kind(PairKind kind, const F& f) {
  TAMIS_ASSERT(is_kind(kind));
  switch (kind) {
    case PairKind::vertex_face:
      return f(std::integral_constant<PairKind, PairKind::vertex_face>{});
    case PairKind::edge_edge:
      return f(std::integral_constant<PairKind, PairKind::edge_edge>{});
    case PairKind::vertex_edge:
      return f(std::integral_constant<PairKind, PairKind::vertex_edge>{});
    case PairKind::vertex_vertex:
      break;
  }
  return f(std::integral_constant<PairKind, PairKind::vertex_vertex>{});
}

/// The same of the kinds that can cross, so f compiles for these alone. REQUIRES: one of them.
template <class F>
decltype(auto) with_crossing_kind(PairKind kind, const F& f) {
  TAMIS_ASSERT(can_cross(kind));
  if (kind == PairKind::vertex_face) return f(std::integral_constant<PairKind, PairKind::vertex_face>{});
  return f(std::integral_constant<PairKind, PairKind::edge_edge>{});
}

}  // namespace tamis

// Enumerates the pairs of features of a mesh: those without a common vertex that the caller's filter lets pass.
#pragma once
#include "numbers/parallel.hpp"
#include "search/query/pair_groups.hpp"
#include "search/query/pair_vertices.hpp"
#include "search/topology/loose_features.hpp"

namespace tamis::yardstick {

inline bool are_adjacent(PairKind kind, const PairVertices& v) {
  if (kind == PairKind::edge_edge) return v[0] == v[2] || v[0] == v[3] || v[1] == v[2] || v[1] == v[3];
  return v[0] == v[1] || v[0] == v[2] || v[0] == v[3];
}

/// Puts the vertices into the order that Contact documents. A face keeps the mesh's winding.
inline PairVertices in_contact_order(PairKind kind, PairVertices v) {
  if (kind == PairKind::edge_edge && std::array{v[2], v[3]} < std::array{v[0], v[1]}) {
    std::swap(v[0], v[2]);
    std::swap(v[1], v[3]);
  }
  if (kind == PairKind::vertex_vertex && v[1] < v[0]) std::swap(v[0], v[1]);
  return v;
}

/// Does the caller's PairFilter let this pair pass? `v` in contact order.
inline bool lets_pass(const PairFilter& filter, PairKind kind, const PairVertices& v) {
  if (has_groups(filter) && !may_touch(filter, v[0], v[second_feature(kind)])) return false;
  return !filter.accepts || of_caller([&] { return filter.accepts(kind, v); });
}

/// Calls f(kind, vertices) for every such pair of features; vertices in contact order.
template <class F>
void for_each_pair(const Mesh& mesh, const PairFilter& filter, const F& f) {
  const auto offer = [&](PairKind kind, PairVertices v) {
    v = in_contact_order(kind, v);
    if (!are_adjacent(kind, v) && lets_pass(filter, kind, v)) f(kind, v);
  };
  for (Index p : mesh.points())
    for (const Face& face : mesh.faces()) offer(PairKind::vertex_face, {p, face[0], face[1], face[2]});
  const auto edges = mesh.edges();
  for (std::size_t j = 0; j < edges.size(); ++j)
    for (std::size_t i = 0; i < j; ++i)
      offer(PairKind::edge_edge, {edges[i][0], edges[i][1], edges[j][0], edges[j][1]});
  const LooseFeatures loose(mesh);
  for (Index p : loose.points) {
    for (const Edge& edge : loose.edges) offer(PairKind::vertex_edge, {p, edge[0], edge[1], -1});
    for (Index q : loose.points)
      if (p < q) offer(PairKind::vertex_vertex, {p, q, -1, -1});
  }
}

}  // namespace tamis::yardstick

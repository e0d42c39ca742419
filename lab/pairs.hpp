// Every pair of features there is.
#pragma once
#include "engines/pair_rules.hpp"
#include "topology/loose_features.hpp"

namespace tamis::lab {

/// Calls f(kind, vertices) for every pair of features that is one; vertices in contact order.
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

}  // namespace tamis::lab

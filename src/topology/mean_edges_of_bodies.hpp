// The mean edge of each body, by its vertices.
#pragma once
#include <algorithm>
#include <vector>

#include "tamis/components.hpp"
#include "topology/at.hpp"
#include "topology/mean_edge.hpp"

namespace tamis {

/// For each vertex, the mean edge of its component: 0 if that has no edges, infinite if the sum of their lengths is.
inline std::vector<double> mean_edges_of_bodies(const Mesh& mesh, const Positions& points) {
  struct Sum {
    double lengths = 0, edges = 0;
  };
  const Components components = components_of(mesh);
  std::vector<Sum> of_component(at(components.count));
  for (const Edge& edge : mesh.edges()) {
    auto& [lengths, edges] = of_component[at(components.of_vertex[at(edge[0])])];
    lengths += edge_length(edge, points);
    ++edges;
  }
  std::vector<double> of_vertex(at(mesh.vertex_count()));
  for (const Index v : mesh.points()) {
    const auto& [lengths, edges] = of_component[at(components.of_vertex[at(v)])];
    of_vertex[at(v)] = lengths / std::max(edges, 1.0);
  }
  return of_vertex;
}

}  // namespace tamis

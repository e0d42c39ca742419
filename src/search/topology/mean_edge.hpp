// The mean edge length of a mesh, of its finest part, of each body: the unit of motion in searches.
#pragma once
#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "numbers/length.hpp"
#include "numbers/mean_of_most.hpp"
#include "search/topology/at.hpp"
#include "tamis/components.hpp"
#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis {

inline double edge_length(const Edge& edge, const Positions& points) {
  const double *a = points[edge[0]], *b = points[edge[1]];
  return quick_length_of(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// The mean of some thousand edges, spread over the mesh, none longer than `most`; 0 without edges, and always finite.
/// A few edges that are much longer than the rest, as of a ground below a cloth, do not count.
inline double mean_edge(const Mesh& mesh, const Positions& points,
                        double most = std::numeric_limits<double>::infinity()) {
  constexpr std::size_t kSample = 4096;
  const auto edges = mesh.edges();
  const auto length = [&](std::size_t e) { return edge_length(edges[e], points); };
  return mean_of_most(edges.size(), 1 + edges.size() / kSample, length, most);
}

/// The mean edge of the finest part of a mesh whose edges are mostly much longer, such as a terrain below a cloth. A
/// limit in the terrain's edges would span the whole cloth. The mean is over edges up to kLonger times as long as the
/// shortest sixteenth.
inline double mean_fine_edge(const Mesh& mesh, const Positions& points) {
  constexpr std::size_t kSample = 64, kSlivers = kSample / 16;
  constexpr double kLonger = 4;
  const auto edges = mesh.edges();
  if (edges.empty()) return 0;
  std::array<double, kSample> lengths;
  for (std::size_t i = 0; i < kSample; ++i) lengths[i] = edge_length(edges[i * edges.size() / kSample], points);
  std::ranges::nth_element(lengths, lengths.begin() + kSlivers);
  return lengths[kSlivers] > 0 ? mean_edge(mesh, points, kLonger * lengths[kSlivers]) : mean_edge(mesh, points);
}

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

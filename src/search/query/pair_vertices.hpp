// The vertices of a pair, and where they are in a step.
#pragma once
#include <algorithm>
#include <array>

#include "numbers/assert.hpp"
#include "pair/motion/make_motion.hpp"
#include "pair/motion/pair_kinds.hpp"

namespace tamis {

using PairVertices = std::array<Index, 4>;  ///< as in Contact, before sorting

/// The vertices that the kind has, and -1 for the others, as Contact documents.
inline PairVertices vertices_in_use(PairKind kind, PairVertices v) {
  std::fill(v.begin() + vertex_count(kind), v.end(), -1);
  return v;
}

/// The points of a pair's vertices; zero where there is none. REQUIRES: vertices of the step.
inline PairPoints points_of(const Step& step, const PairVertices& vertices) {
  PairPoints points{};
  for (std::size_t i = 0; i < 4 && vertices[i] >= 0; ++i) {
    TAMIS_ASSERT(vertices[i] < step.start.count() && vertices[i] < step.end.count());
    std::copy_n(step.start[vertices[i]], 3, points.start[i].begin());
    std::copy_n(step.end[vertices[i]], 3, points.end[i].begin());
  }
  return points;
}

/// The points of a vertex that runs along the edge during the step, and of the face at rest. They touch where edge and
/// face meet.
inline PairPoints edge_runner_points(const Positions& at, const Edge& edge, const Face& face) {
  PairPoints points = points_of({at, at}, {edge[0], face[0], face[1], face[2]});
  std::copy_n(at[edge[1]], 3, points.end[0].begin());
  return points;
}

}  // namespace tamis

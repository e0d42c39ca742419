// The vertices of a pair, where they are, and whether their groups may touch.
#pragma once
#include <algorithm>
#include <array>

#include "motion/make_motion.hpp"
#include "motion/pair_kinds.hpp"
#include "numerics/assert.hpp"
#include "tamis/options.hpp"

namespace tamis {

using PairVertices = std::array<Index, 4>;  ///< as in Contact, before sorting

/// Those that the kind has; -1 in place of the others, as Contact documents.
inline PairVertices vertices_in_use(PairKind kind, PairVertices v) {
  std::fill(v.begin() + vertex_count(kind), v.end(), -1);
  return v;
}

/// Does the filter know groups at all?
inline bool has_groups(const PairFilter& filter) { return !filter.groups_may_touch.empty(); }

/// May the groups of two vertices? REQUIRES: has_groups; vertices that have a group, groups that there are.
inline bool may_touch(const PairFilter& filter, Index a, Index b) {
  TAMIS_ASSERT(has_groups(filter));
  const auto group = [&](Index v) {
    TAMIS_ASSERT(static_cast<std::size_t>(v) < filter.group_of_vertex.size());
    const Index g = filter.group_of_vertex[static_cast<std::size_t>(v)];
    TAMIS_ASSERT(0 <= g && g < filter.group_count);
    return static_cast<std::size_t>(g);
  };
  return filter.groups_may_touch[group(a) * static_cast<std::size_t>(filter.group_count) + group(b)] != 0;
}

/// Where the vertices are; zero where there is none. REQUIRES: vertices of the step.
inline PairPoints points_of(const Step& step, const PairVertices& vertices) {
  PairPoints points{};
  for (std::size_t i = 0; i < 4 && vertices[i] >= 0; ++i) {
    TAMIS_ASSERT(vertices[i] < step.start.count() && vertices[i] < step.end.count());
    std::copy_n(step.start[vertices[i]], 3, points.start[i].begin());
    std::copy_n(step.end[vertices[i]], 3, points.end[i].begin());
  }
  return points;
}

/// Of a vertex that runs along the edge within the step, and the face at rest: where the two meet, edge and face do.
inline PairPoints points_along(const Positions& at, const Edge& edge, const Face& face) {
  PairPoints points = points_of({at, at}, {edge[0], face[0], face[1], face[2]});
  std::copy_n(at[edge[1]], 3, points.end[0].begin());
  return points;
}

}  // namespace tamis

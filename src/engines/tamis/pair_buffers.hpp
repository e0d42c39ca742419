// What both pipelines ask of the kernels' buffers and of the counts of pairs.
#pragma once
#include "engines/pair_rules.hpp"
#include "engines/stage_counts.hpp"
#include "kernels/kernels.hpp"

namespace tamis {

/// In contact order: the search gives them so.
inline PairVertices vertices_of(PairKind kind, const PairBuffer& pairs, int i) {
  PairVertices vertices{-1, -1, -1, -1};
  for (std::size_t c = 0; c < vertex_count(kind); ++c) vertices[c] = pairs.corner[c][i];
  return vertices;
}

/// Loose edges and points are searched as faces are, their last vertex repeated.
inline auto kernel_for_search(const Kernels& kernels, PairKind kind) {
  return kind == PairKind::edge_edge ? kernels.search_ee : kernels.search_vf;
}

/// Keeps the pairs of a buffer for which is_wanted(i). Nothing here waits for a branch.
template <class F>
void keep_wanted(PairBuffer& pairs, const F& is_wanted) {
  int kept = 0;
  for (int i = 0; i < pairs.count; ++i) {
    const bool is_kept = is_wanted(i);
    for (auto& corner : pairs.corner) corner[kept] = corner[i];
    pairs.t_in[kept] = pairs.t_in[i];
    pairs.t_out[kept] = pairs.t_out[i];
    kept += is_kept;
  }
  pairs.count = kept;
}

/// Two loose points are found from both sides.
inline void keep_each_once(PairKind kind, PairBuffer& pairs) {
  if (kind == PairKind::vertex_vertex)
    keep_wanted(pairs, [&](int i) { return pairs.corner[0][i] < pairs.corner[1][i]; });
}

}  // namespace tamis

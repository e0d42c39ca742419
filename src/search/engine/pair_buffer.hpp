// Operations on a PairBuffer. `leave_out` is the one place that excludes pairs by their identity, not by their
// positions. Each consumer calls it where that costs least, before a pair is decided (ProximityConsumer after its
// distance). Only the rings (Query::are_neighbours) are tested after that.
#pragma once
#include "numbers/assert.hpp"
#include "numbers/parallel.hpp"
#include "search/kernels/kernels.hpp"
#include "search/query/pair_groups.hpp"
#include "search/query/pair_vertices.hpp"
#include "search/topology/at.hpp"

namespace tamis {

/// Vertices of pair i, in the order of Contact, as the search gives them. REQUIRES: a pair of the buffer.
inline PairVertices vertices_of(PairKind kind, const PairBuffer& pairs, int i) {
  TAMIS_ASSERT(0 <= i && i < pairs.count);
  return vertices_in_use(kind, {pairs.corner[0][i], pairs.corner[1][i], pairs.corner[2][i], pairs.corner[3][i]});
}

/// Writes the vertices of pair i; its times stay. REQUIRES: 0 <= i < PairBuffer::kSize.
inline void put(PairKind kind, const PairVertices& vertices, PairBuffer& pairs, int i) {
  TAMIS_ASSERT(0 <= i && i < PairBuffer::kSize);
  for (std::size_t c = 0; c < vertex_count(kind); ++c) pairs.corner[c][i] = vertices[c];
}

/// Runs a search kernel from one leaf block. REQUIRES: a buffer and its flush; a block that there is; a time limit in
/// [0,1].
inline void search_block(SearchKernel kernel, Search& search, int block) {
  TAMIS_ASSERT(search.pairs && search.flush && search.pairs->count <= PairBuffer::kCapacity);
  TAMIS_ASSERT(0 <= block && block < search.a.leaf_blocks);
  TAMIS_ASSERT(0 <= search.t_limit && search.t_limit <= 1 && search.widened >= 0);
  kernel(search, block);
}

/// Keeps the pairs for which is_wanted(i); from the first unwanted pair on without branches.
/// REQUIRES: a count within the capacity.
template <class F>
void keep_wanted(PairBuffer& pairs, const F& is_wanted) {
  TAMIS_ASSERT(0 <= pairs.count && pairs.count <= PairBuffer::kCapacity);
  int kept = 0;
  while (kept < pairs.count && is_wanted(kept)) ++kept;  // often all of them
  for (int i = kept + 1; i < pairs.count; ++i) {
    const bool is_kept = is_wanted(i);
    for (auto& corner : pairs.corner) corner[kept] = corner[i];
    pairs.t_in[kept] = pairs.t_in[i];
    pairs.t_out[kept] = pairs.t_out[i];
    kept += is_kept;
  }
  pairs.count = kept;
}

/// The search finds each pair of loose points from both sides. Keeps one of the two.
inline void keep_each_once(PairKind kind, PairBuffer& pairs) {
  if (kind == PairKind::vertex_vertex)
    keep_wanted(pairs, [&](int i) { return pairs.corner[0][i] < pairs.corner[1][i]; });
}

/// Removes the pairs that have no changed vertex (Query::changed).
inline void leave_out_unchanged(std::span<const std::uint8_t> changed, PairKind kind, PairBuffer& pairs) {
  if (changed.empty()) return;
  keep_wanted(pairs, [&, count = vertex_count(kind)](int i) {
    std::uint8_t any = 0;
    for (std::size_t c = 0; c < count; ++c) any |= changed[at(pairs.corner[c][i])];
    return any != 0;
  });
}

/// Removes pairs whose groups may not touch.
inline void leave_out_groups(const PairFilter& filter, PairKind kind, PairBuffer& pairs) {
  if (!has_groups(filter)) return;
  keep_wanted(pairs, [&, second = second_feature(kind)](int i) {
    return may_touch(filter, pairs.corner[0][i], pairs.corner[second][i]);
  });
}

/// Removes pairs that the caller's filter does not let pass.
inline void leave_out(const PairFilter& filter, PairKind kind, PairBuffer& pairs) {
  leave_out_groups(filter, kind, pairs);
  if (!filter.accepts) return;
  of_caller([&] { keep_wanted(pairs, [&](int i) { return filter.accepts(kind, vertices_of(kind, pairs, i)); }); });
}

}  // namespace tamis

// The stages in lanes over one buffer of pairs, and how their results are read.
#pragma once
#include "query/pair_vertices.hpp"
#include "search/workspace.hpp"

namespace tamis {

/// Decides which pairs of thread.boxes touch: slab clip, DNF and NCF, roots in lanes. Returns how many entries of
/// thread.solved there are, pairs that touch or are undecided; each names its place in thread.filtered. `stages`: of
/// the kind, or along_edges.
int decide_crossings(SearchThread& thread, PairKind kind, const PairKernels& stages);

/// The same without roots: pairs that the filters leave are in thread.filtered.
void filter_crossings(SearchThread& thread, PairKind kind, const PairKernels& stages);

/// Decides which pairs come within their separation until `latest`: slab clip, axes that turn, advancement in lanes.
/// Results as above.
int decide_within_separation(SearchThread& thread, PairKind kind, double latest);

/// Calls add(place, PairResult) for each pair that touches, and decide_singly(place) for each that is undecided.
/// REQUIRES: the first `count` entries of thread.solved name pairs of thread.filtered.
template <class Add, class DecideSingly>
void for_each_solved(SearchThread& thread, int count, const Add& add, const DecideSingly& decide_singly) {
  TAMIS_ASSERT(0 <= count && count <= thread.filtered.count);
  int undecided = 0;
  for (int i = 0; i < count; ++i) {
    const SolvedPair& s = thread.solved[static_cast<std::size_t>(i)];
    if (s.is_decided) {
      const Point normal{s.normal[0], s.normal[1], s.normal[2]};
      add(s.pair, PairResult{true, Certainty::certified, s.toi_lower, s.toi_upper, s.u, s.v, normal});
    } else {
      decide_singly(s.pair);
      ++undecided;
    }
  }
  thread.counts.decided_by.lanes += static_cast<std::uint64_t>(thread.filtered.count - undecided);
}

}  // namespace tamis

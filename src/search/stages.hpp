// The stages that decide pairs of a step in lanes, over one buffer, and what becomes of the pairs they leave undecided.
#pragma once
#include "query/pair_rules.hpp"
#include "search/workspace.hpp"

namespace tamis {

/// Do pairs touch? Slab clip, DNF and NCF, roots in lanes. Takes thread.boxes, and returns how many pairs of
/// thread.solved touch or are undecided; they are places in thread.filtered. `stages`: of the kind, or along_edges.
int decide_crossings(SearchThread& thread, PairKind kind, const PairKernels& stages);

/// The same without roots: leaves thread.filtered.
void filter_crossings(SearchThread& thread, PairKind kind, const PairKernels& stages);

/// Do pairs come within their separation, until `latest`? The same with a slab clip, axes that turn, distances in
/// lanes.
int decide_within_separation(SearchThread& thread, PairKind kind, double latest);

/// Calls add(place, PairResult) for each pair that lanes found to touch, and decide_singly(place) for each that they
/// left undecided. REQUIRES: the first `count` of thread.solved speak of thread.filtered.
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

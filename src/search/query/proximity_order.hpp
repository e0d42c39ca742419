// The documented order of pairs at rest.
#pragma once
#include <functional>
#include <vector>

#include "numbers/counting_sort.hpp"
#include "search/query/pair_vertices.hpp"

namespace tamis {

/// Sorts pairs of one kind by their vertices. Keeps its scratch memory from call to call. Runs in the caller's
/// arena. Calls `pause` now and then, from several threads. An exception from `pause` ends the sort.
class ProximityOrder {
 public:
  void sort(
      std::vector<PairVertices>& pairs, Index vertex_count, const std::function<void()>& pause = [] {});
  std::uint64_t memory_bytes() const { return held_bytes(counting_, sorted_); }

 private:
  CountingSort counting_;
  std::vector<PairVertices> sorted_;
};

}  // namespace tamis

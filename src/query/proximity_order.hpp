// The documented order of pairs at rest.
#pragma once
#include <functional>
#include <vector>

#include "numerics/held_bytes.hpp"
#include "query/pair_vertices.hpp"

namespace tamis {

/// Sorts pairs of one kind by their vertices; keeps its scratch memory from call to call. Runs in the caller's oneTBB
/// arena. Calls `pause` now and then; an exception of that ends the sort.
class ProximityOrder {
 public:
  void sort(
      std::vector<PairVertices>& pairs, Index vertex_count, const std::function<void()>& pause = [] {});
  std::uint64_t memory_bytes() const { return held_bytes(places_, sorted_); }

 private:
  void sort_by(std::size_t corner, std::vector<PairVertices>& pairs, std::size_t buckets);

  std::vector<std::uint32_t>
      places_;  ///< [part of the pairs][vertex]: how many there are, then where the next one goes
  std::vector<PairVertices> sorted_;
};

}  // namespace tamis

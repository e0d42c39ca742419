#include "search/query/proximity_order.hpp"

#include <algorithm>

namespace tamis {
namespace {

/// With more vertices for each pair than this, a comparison sort. Counters would be most of the work.
constexpr std::size_t kVerticesPerPair = 8;

}  // namespace

/// A radix sort: stable passes by each vertex, the first vertex in the last pass. No branch depends on a pair. A
/// comparison sort of each vertex's pairs took twice as long.
void ProximityOrder::sort(std::vector<PairVertices>& pairs, Index vertex_count, const std::function<void()>& pause) {
  const std::size_t buckets = static_cast<std::size_t>(vertex_count) + 1;  // the first is for -1, no vertex
  if (pairs.size() < buckets / kVerticesPerPair) return std::sort(pairs.begin(), pairs.end());
  sorted_.resize(pairs.size());
  for (const std::size_t corner : {3u, 2u, 1u, 0u}) {
    counting_.find_places(
        pairs.size(), buckets, [&](std::size_t i) { return static_cast<std::size_t>(pairs[i][corner]) + 1; },
        [&](std::size_t i, std::size_t place) { sorted_[place] = pairs[i]; }, pause);
    pairs.swap(sorted_);
  }
}

}  // namespace tamis

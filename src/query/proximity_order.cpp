#include "query/proximity_order.hpp"

#include <algorithm>
#include <span>

#include "numerics/in_parts.hpp"

namespace tamis {
namespace {

/// With more vertices for each pair than this, a comparison sort: counters would be most of the work.
constexpr std::size_t kVerticesPerPair = 8;

/// Sorts runs of pairs that differ in the last vertex alone.
void sort_by_last(std::span<PairVertices> pairs) {
  const auto differ = [](const PairVertices& a, const PairVertices& b) {
    return a[2] != b[2] || a[1] != b[1] || a[0] != b[0];
  };
  for (auto first = pairs.begin(); first != pairs.end();) {
    const auto last =
        std::find_if(first + 1, pairs.end(), [&](const PairVertices& pair) { return differ(*first, pair); });
    if (last - first > 1)
      std::sort(first, last, [](const PairVertices& a, const PairVertices& b) { return a[3] < b[3]; });
    first = last;
  }
}

}  // namespace

/// A radix sort: stable passes by all vertices but the last, the first vertex in the last pass. No branch depends on a
/// pair; a comparison sort of each vertex's pairs took twice as long.
void ProximityOrder::sort(std::vector<PairVertices>& pairs, Index vertex_count, const std::function<void()>& pause) {
  const std::size_t buckets = static_cast<std::size_t>(vertex_count) + 1;  // the first is for -1, no vertex
  if (pairs.size() < buckets / kVerticesPerPair) return std::sort(pairs.begin(), pairs.end());
  sorted_.resize(pairs.size());
  for (const std::size_t corner : {2u, 1u, 0u}) {
    counting_.find_places(
        pairs.size(), buckets, [&](std::size_t i) { return static_cast<std::size_t>(pairs[i][corner]) + 1; },
        [&](std::size_t i, std::size_t place) { sorted_[place] = pairs[i]; }, pause);
    pairs.swap(sorted_);
  }
  in_parts(buckets, kVerticesPerPart, [&](std::size_t first, std::size_t end) {
    const std::size_t begin_of_pairs = counting_.begin_of(first);
    sort_by_last(std::span(pairs).subspan(begin_of_pairs, counting_.end_of(end - 1) - begin_of_pairs));
  });
}

}  // namespace tamis

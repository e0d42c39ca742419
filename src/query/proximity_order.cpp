#include "query/proximity_order.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <span>
#include <utility>

#include "numerics/assert.hpp"

namespace tamis {
namespace {

/// A part that is counted separately needs as many counters as there are vertices, and is worth that with so many pairs
/// a counter.
constexpr std::size_t kPairsPerCounter = 4;

/// With more vertices a pair the counters would be most of the work: then a comparison sort.
constexpr std::size_t kVerticesPerPair = 8;

/// Bucket 0 is for -1, no vertex. REQUIRES: a vertex of the mesh, or -1.
std::size_t bucket_of(const PairVertices& pair, std::size_t corner, [[maybe_unused]] std::size_t buckets) {
  const std::size_t bucket = static_cast<std::size_t>(pair[corner]) + 1;
  TAMIS_ASSERT(bucket < buckets);
  return bucket;
}

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
  const std::size_t buckets = static_cast<std::size_t>(vertex_count) + 1;
  if (pairs.size() < buckets / kVerticesPerPair) return std::sort(pairs.begin(), pairs.end());
  sorted_.resize(pairs.size());
  for (const std::size_t corner : {2u, 1u, 0u}) {
    sort_by(corner, pairs, buckets);
    pause();
  }
  sort_by_last(pairs);
}

/// One stable counting sort, by parts in parallel.
void ProximityOrder::sort_by(std::size_t corner, std::vector<PairVertices>& pairs, std::size_t buckets) {
  const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  const std::size_t parts = std::clamp(pairs.size() / (kPairsPerCounter * buckets), std::size_t{1}, threads);
  const auto for_each_part = [&](const auto& f) {
    tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t part) {
      const std::size_t first = pairs.size() * part / parts, last = pairs.size() * (part + 1) / parts;
      for (std::size_t i = first; i < last; ++i)
        f(pairs[i], places_[part * buckets + bucket_of(pairs[i], corner, buckets)]);
    });
  };
  places_.assign(parts * buckets, 0);
  for_each_part([](const PairVertices&, std::uint32_t& count) { ++count; });
  std::uint32_t place = 0;
  for (std::size_t bucket = 0; bucket < buckets; ++bucket)
    for (std::size_t part = 0; part < parts; ++part) place += std::exchange(places_[part * buckets + bucket], place);
  for_each_part([&](const PairVertices& pair, std::uint32_t& next) { sorted_[next++] = pair; });
  pairs.swap(sorted_);
}

}  // namespace tamis

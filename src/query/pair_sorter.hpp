// The documented order of pairs in an answer: by kind, then vertices. Here those of one kind.
#pragma once
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "numerics/assert.hpp"
#include "numerics/held_bytes.hpp"
#include "query/pair_vertices.hpp"

namespace tamis {

/// Keeps its scratch memory from call to call. `Pair`: PairVertices, or what derives from them.
template <class Pair>
class PairSorter {
 public:
  /// `comes_before`: the order of pairs that may have the same vertices. Runs in the caller's oneTBB arena. Calls
  /// `pause` now and then; an exception of that ends the sort.
  template <class ComesBefore>
  void sort(std::vector<Pair>& pairs, Index vertex_count, const ComesBefore& comes_before,
            const std::function<void()>& pause);
  std::uint64_t memory_bytes() const { return held_bytes(places_, sorted_); }

 private:
  /// A part that is counted separately needs as many counters as there are vertices, and is worth that with so many
  /// pairs a counter.
  static constexpr std::size_t kPairsPerCounter = 4;
  /// With more vertices a pair the counters would be most of the work: then a comparison sort.
  static constexpr std::size_t kVerticesPerPair = 8;

  void sort_by(std::size_t corner, std::vector<Pair>& pairs, std::size_t buckets);

  std::vector<std::uint32_t>
      places_;  ///< [part of the pairs][vertex]: how many there are, then where the next one goes
  std::vector<Pair> sorted_;
};

/// A radix sort: stable passes by all vertices but the last, the first vertex in the last pass; then runs of pairs that
/// differ in nothing else. No branch depends on a pair; a comparison sort of each vertex's pairs took twice as long.
template <class Pair>
template <class ComesBefore>
void PairSorter<Pair>::sort(std::vector<Pair>& pairs, Index vertex_count, const ComesBefore& comes_before,
                            const std::function<void()>& pause) {
  const std::size_t buckets = static_cast<std::size_t>(vertex_count) + 1;
  if (pairs.size() < buckets / kVerticesPerPair) return std::sort(pairs.begin(), pairs.end(), comes_before);
  sorted_.resize(pairs.size());
  for (const std::size_t corner : {2u, 1u, 0u}) {
    sort_by(corner, pairs, buckets);
    pause();
  }
  const auto differ = [](const Pair& a, const Pair& b) { return a[2] != b[2] || a[1] != b[1] || a[0] != b[0]; };
  for (auto first = pairs.begin(); first != pairs.end();) {
    const auto last = std::find_if(first + 1, pairs.end(), [&](const Pair& pair) { return differ(*first, pair); });
    if (last - first > 1) std::sort(first, last, comes_before);
    first = last;
  }
}

/// One stable counting sort, by parts in parallel. Bucket 0 is for -1, no vertex.
template <class Pair>
void PairSorter<Pair>::sort_by(std::size_t corner, std::vector<Pair>& pairs, std::size_t buckets) {
  const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  const std::size_t parts = std::clamp(pairs.size() / (kPairsPerCounter * buckets), std::size_t{1}, threads);
  const auto for_each_part = [&](const auto& f) {
    tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t part) {
      const std::size_t first = pairs.size() * part / parts, last = pairs.size() * (part + 1) / parts;
      for (std::size_t i = first; i < last; ++i) {
        const auto bucket = static_cast<std::size_t>(pairs[i][corner] + 1);
        TAMIS_ASSERT(bucket < buckets);
        f(pairs[i], places_[part * buckets + bucket]);
      }
    });
  };
  places_.assign(parts * buckets, 0);
  for_each_part([](const Pair&, std::uint32_t& count) { ++count; });
  std::uint32_t place = 0;
  for (std::size_t bucket = 0; bucket < buckets; ++bucket)
    for (std::size_t part = 0; part < parts; ++part) place += std::exchange(places_[part * buckets + bucket], place);
  for_each_part([&](const Pair& pair, std::uint32_t& next) { sorted_[next++] = pair; });
  pairs.swap(sorted_);
}

}  // namespace tamis

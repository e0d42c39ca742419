#include "engines/near_order.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <tuple>

namespace tamis {

/// A counting sort by the first vertex, then each small bucket by the others.
void NearOrder::sort(std::vector<PairVertices>& pairs, Index vertex_count) {
  const auto buckets = static_cast<std::size_t>(vertex_count);
  const auto bucket_of = [](const PairVertices& v) { return static_cast<std::size_t>(v[0]); };
  first_.assign(buckets + 2, 0);
  for (const PairVertices& v : pairs) ++first_[bucket_of(v) + 2];
  for (std::size_t b = 2; b < first_.size(); ++b) first_[b] += first_[b - 1];
  sorted_.resize(pairs.size());
  for (const PairVertices& v : pairs) sorted_[first_[bucket_of(v) + 1]++] = v;
  const auto is_before = [](const PairVertices& a, const PairVertices& b) {
    const auto key = [](const PairVertices& v) {
      return std::tuple(std::uint64_t{static_cast<std::uint32_t>(v[1])} << 32 | static_cast<std::uint32_t>(v[2]), v[3]);
    };
    return key(a) < key(b);
  };
  constexpr std::size_t kGrain = 1024;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, buckets, kGrain), [&](const auto& range) {
    for (std::size_t b = range.begin(); b != range.end(); ++b)
      if (first_[b + 1] > first_[b] + 1)
        std::sort(sorted_.begin() + first_[b], sorted_.begin() + first_[b + 1], is_before);
  });
  pairs.swap(sorted_);
}

}  // namespace tamis

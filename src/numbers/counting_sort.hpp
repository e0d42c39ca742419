// A stable counting sort, in parallel.
#pragma once
#include <algorithm>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "numbers/assert.hpp"
#include "numbers/held_bytes.hpp"
#include "numbers/parallel.hpp"

namespace tamis {

/// Finds where items go when they are sorted by their bucket, a number each. Keeps its counters from call to call.
class CountingSort {
 public:
  /// Calls put(i, place) once for each i in [0, count). Each place in [0, count) comes once. Places ascend by
  /// bucket_of(i), in [0, buckets), then by i. The threads of the arena call all three functions.
  /// `pause` is called now and then; an exception that it throws ends the sort. REQUIRES: count < 2^32.
  template <class BucketOf, class Put>
  void find_places(std::size_t count, std::size_t buckets, const BucketOf& bucket_of, const Put& put,
                   const std::function<void()>& pause) {
    TAMIS_ASSERT(count >> 32 == 0 && buckets > 0);
    const auto threads = static_cast<std::size_t>(threads_here());
    const std::size_t parts = std::clamp(count / buckets, std::size_t{1}, threads);
    const auto for_each_item = [&](const auto& f) {
      const auto place_part = [&](std::size_t part) {
        std::uint32_t* const counters = places_.data() + part * buckets;
        const std::size_t end = count * (part + 1) / parts;
        for (std::size_t i = count * part / parts; i < end;) {
          pause();
          for (const std::size_t until = std::min(end, i + kItemsPerPause); i < until; ++i) {
            const std::size_t bucket = bucket_of(i);
            TAMIS_ASSERT(bucket < buckets);
            f(i, counters[bucket]);
          }
        }
      };
      parallel_for(parts, 1, [&](std::size_t part, std::size_t end) {
        for (; part != end; ++part) place_part(part);
      });
    };
    places_.assign(parts * buckets, 0);
    for_each_item([](std::size_t, std::uint32_t& counted) { ++counted; });
    std::uint32_t place = 0;
    for (std::size_t bucket = 0; bucket < buckets; ++bucket)
      for (std::size_t part = 0; part < parts; ++part) place += std::exchange(places_[part * buckets + bucket], place);
    for_each_item([&](std::size_t i, std::uint32_t& next) { put(i, next++); });
    ends_ = (parts - 1) * buckets;
  }
  /// The places of the last call's bucket are [begin, end).
  std::uint32_t begin_of(std::size_t bucket) const { return bucket == 0 ? 0 : end_of(bucket - 1); }
  std::uint32_t end_of(std::size_t bucket) const { return places_[ends_ + bucket]; }
  std::uint64_t memory_bytes() const { return held_bytes(places_); }

 private:
  /// Items between two calls of `pause`: below a tenth of a millisecond.
  static constexpr std::size_t kItemsPerPause = std::size_t{1} << 14;

  /// [part of the items][bucket]: first the number of its items, then the place of its next one. There is a part for
  /// each thread, unless the counters would be most of the work.
  std::vector<std::uint32_t> places_;
  std::size_t ends_ = 0;  ///< where the last part's counters begin: after a call, the ends of the buckets' places
};

}  // namespace tamis

#include "search/proximity_search.hpp"

#include "numerics/in_parts.hpp"
#include "query/cancellation.hpp"
#include "topology/countable.hpp"

namespace tamis {

void ProximitySearch::find(const Query& query, std::vector<NearPair>& pairs, Statistics& statistics) {
  workspace_.trees.refit_or_rebuild(query.step, query.separations, LooksAt::start, statistics);
  Stopwatch watch;
  streams_.begin(query);
  workspace_.trees.for_each_kind(
      [&](PairKind kind, const TreeView& a, const TreeView& b) { streams_.search(kind, a, b); });
  streams_.report(statistics, watch.lap(), {&SearchCounts::boxes, &SearchCounts::near});
  gather(query);
  describe(pairs);
  statistics.seconds.solve += watch.lap();
}

void ProximitySearch::gather(const Query& query) {
  for (auto& list : lists_) list.clear();
  streams_.for_each([&](ProximityConsumer& consumer) {
    for (std::size_t kind = 0; kind < kPairKinds; ++kind) {
      auto &list = lists_[kind], &found = consumer.found(static_cast<PairKind>(kind));
      if (list.empty())
        list.swap(found);
      else
        list.insert(list.end(), found.begin(), found.end());
    }
  });
  for (auto& list : lists_) {
    require_countable_pairs(list.size());
    order_.sort(list, workspace_.mesh.vertex_count(), [&] { stop_if_cancelled(query); });
  }
}

void ProximitySearch::describe(std::vector<NearPair>& pairs) {
  std::size_t count = 0;
  for (const auto& list : lists_) count += list.size();
  pairs.resize(count);
  NearPair* out = pairs.data();
  for (std::size_t kind = 0; kind < kPairKinds; ++kind) {
    const auto& list = lists_[kind];
    constexpr std::size_t kGrain = 4096;
    in_parts(list.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      streams_.consumer().describe(static_cast<PairKind>(kind), std::span(list).subspan(begin, end - begin),
                                   out + begin);
    });
    out += list.size();
  }
}

std::uint64_t ProximitySearch::memory_bytes() const {
  std::uint64_t bytes = order_.memory_bytes() + streams_.memory_bytes();
  for (const auto& list : lists_) bytes += list.capacity() * sizeof(PairVertices);
  return bytes;
}

}  // namespace tamis

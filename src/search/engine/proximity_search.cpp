#include "search/engine/proximity_search.hpp"

#include <algorithm>
#include <cmath>

#include "numbers/in_parts.hpp"
#include "pair/narrow/near_pair.hpp"
#include "search/engine/pair_buffer.hpp"
#include "search/query/cancellation.hpp"
#include "search/topology/countable.hpp"

namespace tamis {

void ProximityConsumer::begin(const Query& query) {
  PairStream::begin(query);
  for (auto& pairs : found_) pairs.clear();
}

void ProximityConsumer::consume(PairKind kind, PairBuffer& pairs) {
  SearchCounts& counts = thread().counts;
  PairBuffer &within = thread().clipped, &unsure = thread().filtered;
  of(counts.boxes, kind) += static_cast<std::uint64_t>(pairs.count);
  thread().kernels.of(kind).find_within_at_rest(thread().motion.view(), pairs, within, unsure);
  counts.decided_by.lanes += static_cast<std::uint64_t>(pairs.count - unsure.count);
  keep_wanted(unsure, [&](int i) {
    stop_if_cancelled(query());
    const PairVertices v = vertices_of(kind, unsure, i);
    return may_start_within(kind, points_of(query().step, v), query().separations.between(kind, v), counts.decided_by);
  });
  keep(kind, within);
  keep(kind, unsure);
}

/// The caller's filter and the rings come last. They may cost more than a distance.
void ProximityConsumer::keep(PairKind kind, PairBuffer& pairs) {
  leave_out(query().filter, kind, pairs);
  if (query().rings.any())
    keep_wanted(pairs, [&](int i) { return !query().are_neighbours(kind, vertices_of(kind, pairs, i)); });
  auto& list = found(kind);
  const std::size_t before = list.size(), count = static_cast<std::size_t>(pairs.count);
  list.resize(before + count);
  for (std::size_t i = 0; i < count; ++i) list[before + i] = vertices_of(kind, pairs, static_cast<int>(i));
  of(thread().counts.near, kind) += count;
}

void ProximityConsumer::describe(PairKind kind, std::span<const PairVertices> pairs, NearPair* out) {
  constexpr std::size_t kAtOnce = 128;  // so few pairs stay in the first cache
  PairBuffer& buffer = thread().clipped;
  for (std::size_t first = 0; first < pairs.size(); first += kAtOnce) {
    stop_if_cancelled(query());
    buffer.count = static_cast<int>(std::min(kAtOnce, pairs.size() - first));
    for (int i = 0; i < buffer.count; ++i) put(kind, pairs[first + static_cast<std::size_t>(i)], buffer, i);
    NearPair* const said = out + first;
    thread().kernels.of(kind).measure(thread().motion.vertices.data(), buffer, said);
    for (int i = 0; i < buffer.count; ++i)
      if (std::isnan(said[i].distance))
        said[i] = near_pair(kind, said[i].vertices, points_of(query().step, said[i].vertices));
  }
}

void ProximitySearch::find(const Query& query, std::vector<NearPair>& pairs, Statistics& statistics) {
  workspace_.trees.refit_or_rebuild(query.step, query.separations, nullptr, LooksAt::start, statistics);
  Stopwatch watch;
  streams_.begin(query);
  streams_.search_trees();
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
      streams_.take()->describe(static_cast<PairKind>(kind), std::span(list).subspan(begin, end - begin), out + begin);
    });
    out += list.size();
  }
}

}  // namespace tamis

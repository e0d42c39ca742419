// The pairs within a distance at rest, in their order, and what is to be said of each.
#pragma once
#include <array>

#include "query/proximity_order.hpp"
#include "search/proximity_consumer.hpp"
#include "search/thread_streams.hpp"

namespace tamis {

class ProximitySearch {
 public:
  /// Keeps a reference.
  explicit ProximitySearch(Workspace& workspace) : workspace_(workspace), streams_(workspace) {}

  /// As Engine::find_near.
  void find(const Query& query, std::vector<NearPair>& pairs, Statistics& statistics);
  std::uint64_t memory_bytes() const;

 private:
  /// Puts what the threads found into one list a kind, in order.
  void gather(const Query& query);
  void describe(std::vector<NearPair>& pairs);

  Workspace& workspace_;
  std::array<std::vector<PairVertices>, kPairKinds> lists_;  ///< in order, once all threads have searched
  ProximityOrder order_;
  ThreadStreams<ProximityConsumer> streams_;
};

}  // namespace tamis

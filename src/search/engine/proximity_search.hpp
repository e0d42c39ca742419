// Finds the pairs within a distance in one pose, in order, and the NearPair of each.
#pragma once
#include <array>
#include <vector>

#include "numbers/held_bytes.hpp"
#include "search/engine/thread_streams.hpp"
#include "search/query/pair_vertices.hpp"
#include "search/query/proximity_order.hpp"
#include "tamis/proximity.hpp"

namespace tamis {

/// Consumer for pairs_within: closest points in lanes, integers where doubles do not tell.
class ProximityConsumer final : public PairStream {
 public:
  using Shared = const Query;

  using PairStream::PairStream;

  void begin(const Query& query);
  /// Pairs of one kind that were found, in no order.
  std::vector<PairVertices>& found(PairKind kind) { return found_[static_cast<std::size_t>(kind)]; }
  /// Writes a NearPair for each of these pairs to `out`.
  void describe(PairKind kind, std::span<const PairVertices> pairs, NearPair* out);

  SearchKernel kernel(PairKind kind) const override { return thread().kernels.of(kind).search_at_rest; }
  void set_limits(Search& search) const override { search.widened = thread().motion.view().box_separation.fixed; }
  void consume(PairKind kind, PairBuffer& pairs) override;
  std::uint64_t memory_bytes() const { return held_bytes(found_); }

 private:
  void keep(PairKind kind, PairBuffer& pairs);

  std::array<std::vector<PairVertices>, kPairKinds> found_;
};

class ProximitySearch {
 public:
  /// Keeps a reference.
  explicit ProximitySearch(Workspace& workspace) : workspace_(workspace), streams_(workspace) {}

  /// As Engine::find_near.
  void find(const Query& query, std::vector<NearPair>& pairs, Statistics& statistics);
  std::uint64_t memory_bytes() const { return held_bytes(order_, streams_, lists_); }

 private:
  /// Merges the threads' pairs into one ordered list a kind.
  void gather(const Query& query);
  void describe(std::vector<NearPair>& pairs);

  Workspace& workspace_;
  std::array<std::vector<PairVertices>, kPairKinds> lists_;  ///< in order, once all threads have searched
  ProximityOrder order_;
  ThreadStreams<ProximityConsumer> streams_;
};

}  // namespace tamis

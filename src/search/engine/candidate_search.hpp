// Lists, for later queries, the pairs that may touch on a step although vertices deviate from it. Prepares lists or
// trees for a query.
#pragma once
#include <atomic>
#include <cstdint>

#include "search/coherence/kept_lists.hpp"
#include "search/engine/thread_streams.hpp"
#include "search/query/bound.hpp"

namespace tamis {

/// Shared by the threads.
struct CandidateQuery {
  const Query& query;
  std::atomic<std::int64_t> pairs_left;  ///< how many more may be listed
  Bound bound = {};                      ///< settled: the listing is given up
};

/// Lists pairs that may touch although vertices deviate from the step, and decides none.
class CandidateConsumer final : public PairStream {
 public:
  using Shared = CandidateQuery;

  using PairStream::PairStream;

  void begin(CandidateQuery& shared);
  /// The pairs found since they were last taken.
  PairLists& candidates() { return candidates_; }
  /// Frees the memory of the lists: only one query in many makes lists.
  void release() { candidates_ = {}; }

  bool wants(PairKind) const override { return !shared_->bound.is_settled(); }
  SearchKernel kernel(PairKind kind) const override { return thread().kernels.of(kind).search; }
  void consume(PairKind kind, PairBuffer& pairs) override;
  std::uint64_t memory_bytes() const { return candidates_.memory_bytes(); }

 private:
  CandidateQuery* shared_ = nullptr;
  PairLists candidates_;
};

class CandidateSearch {
 public:
  /// Keeps a reference.
  explicit CandidateSearch(Workspace& workspace) : workspace_(workspace), streams_(workspace) {}

  /// Adds to `lists`, in no order, the pairs of the listing. Filter, rings and cancellation are the query's. Returns
  /// false if some are missing: there are more than kMostPairsPerBlock times the blocks, or the first samples suggest
  /// it. Leaves the trees refitted to the listing's step.
  bool list(const Query& query, const Listing& listing, PairLists& lists, Statistics& statistics);
  /// Prepares lists or trees for a query. Returns true if the lists serve the query. The vertices of this step are then
  /// loaded, if the lists hold any pair. Returns false if the trees must be searched, which are then of this step.
  /// `is_listed`: the present lists serve this query. If not, others are made if they are worth their cost.
  bool prepare(const Query& query, LooksAt looks_at, bool is_listed, KeptLists& kept, Statistics& statistics);
  std::uint64_t memory_bytes() const { return streams_.memory_bytes(); }

 private:
  /// The lists hold at most this many pairs for each leaf block.
  static constexpr std::int64_t kMostPairsPerBlock = 256;
  /// Samples are uneven. The first ones may exceed their share of the pairs by this part of the most.
  static constexpr double kSmallestPart = 1.0 / 64;

  Workspace& workspace_;
  ThreadStreams<CandidateConsumer> streams_;
};

}  // namespace tamis

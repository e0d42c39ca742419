// Lists pairs that may touch although vertices deviate from the step, and decides none.
#pragma once
#include <array>
#include <atomic>

#include "query/bound.hpp"
#include "search/pair_stream.hpp"

namespace tamis {

/// What the threads share.
struct CandidateQuery {
  const Query& query;
  double deviation;                ///< how far vertices may be from where the step has them, along any axis
  std::atomic<std::int64_t> left;  ///< how many more may be listed
  Bound bound = {};                ///< settled: there are too many
};

class CandidateConsumer final : public PairConsumer {
 public:
  static constexpr bool kHoldsPairsBack = true;
  using Asked = CandidateQuery;

  using PairConsumer::PairConsumer;

  void begin(CandidateQuery& asked);
  /// Those found since they were last taken.
  PairList& candidates(PairKind kind) { return candidates_[static_cast<std::size_t>(kind)]; }
  /// Gives back the memory of the lists: they are made once in many queries.
  void release() { candidates_ = {}; }

  bool wants(PairKind) const override { return !asked_->bound.is_settled(); }
  SearchKernel kernel(PairKind kind) const override { return thread().kernels.of(kind).search; }
  void consume(PairKind kind) override;
  std::uint64_t memory_bytes() const;

 private:
  CandidateQuery* asked_ = nullptr;
  std::array<PairList, kPairKinds> candidates_;
};

}  // namespace tamis

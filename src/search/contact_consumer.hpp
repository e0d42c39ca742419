// Decides pairs of a step: slab clip, DNF and NCF, roots in lanes, and one by one what those leave undecided; with a
// separation axes that turn and distances in place of DNF, NCF and roots.
#pragma once
#include <array>
#include <memory>

#include "query/contact_collector.hpp"
#include "search/pair_stream.hpp"

namespace tamis {

class ContactConsumer final : public PairStream {
 public:
  static constexpr bool kHoldsPairsBack = true;
  using Shared = const ContactCollector;

  using PairStream::PairStream;

  /// Of the answer, which has begun.
  void begin(const ContactCollector& answer) {
    PairStream::begin(answer.query());
    found_.begin(answer.query(), answer.bound());
    found_.learn(answer);
  }
  ContactCollector& found() { return found_; }

  bool wants(PairKind kind) const override { return found_.wants(kind); }
  SearchKernel kernel(PairKind kind) const override { return thread().kernels.of(kind).search; }
  void consume(PairKind kind) override;
  std::uint64_t memory_bytes() const { return found_.memory_bytes() + (by_pair_ ? sizeof(ByPair) : 0); }

 private:
  /// Before any work: what the caller's filter, or what is known already, leaves out.
  void leave_out_unwanted(PairKind kind);
  /// Those of thread().boxes as a list's (Query::is_by_pair).
  void decide_by_pair(PairKind kind);
  void add(PairKind kind, const PairVertices& vertices, PairResult& result);
  void decide_singly(PairKind kind, const PairVertices& vertices);

  struct ByPair {
    std::array<std::int32_t, PairBuffer::kSize> places, undecided;
    std::array<PairResult, PairBuffer::kCapacity> results;
  };

  ContactCollector found_;
  std::unique_ptr<ByPair> by_pair_;  ///< made where it is used
};

}  // namespace tamis

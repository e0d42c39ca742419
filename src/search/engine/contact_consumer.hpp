// Consumer for contacts, earliest and is_free: slab clip, DNF and NCF, roots in lanes, then the undecided pairs one by
// one. With a separation, axes that turn with the pair and advancement take the place of DNF, NCF and roots.
#pragma once
#include <array>
#include <memory>
#include <span>

#include "search/engine/pair_stream.hpp"
#include "search/query/contact_collector.hpp"

namespace tamis {

class ContactConsumer final : public PairStream {
 public:
  using Shared = const ContactCollector;

  using PairStream::PairStream;

  /// REQUIRES: an answer that has begun.
  void begin(const ContactCollector& answer) {
    PairStream::begin(answer.query());
    found_.begin(answer.query(), answer.bound());
    found_.learn(answer);
  }
  ContactCollector& found() { return found_; }

  bool wants(PairKind kind) const override { return found_.wants(kind); }
  SearchKernel kernel(PairKind kind) const override { return thread().kernels.of(kind).search; }
  void consume(PairKind kind) override;
  std::uint64_t memory_bytes() const { return found_.memory_bytes() + (list_scratch_ ? sizeof(ListScratch) : 0); }

 private:
  /// Removes pairs that groups or the caller's filter leave out, or that can no longer change the answer.
  void leave_out_unwanted(PairKind kind);
  /// Ends each pair's time at the latest one of interest for its bodies: the slab clip then removes pairs that come
  /// later.
  void shorten_times(PairKind kind);
  /// Decides the pairs of thread().boxes as narrow_phase() decides a list (Query::depends_on_pair_alone).
  void decide_as_list(PairKind kind);
  void add(PairKind kind, const PairVertices& vertices, PairResult result);
  /// `places`: of pairs in thread().filtered.
  void decide_left(PairKind kind, std::span<const int> places);

  struct ListScratch {
    std::array<std::int32_t, PairBuffer::kSize> places, undecided;
    std::array<PairResult, PairBuffer::kCapacity> results;
  };

  ContactCollector found_;
  std::unique_ptr<ListScratch> list_scratch_;  ///< made when first used
};

}  // namespace tamis

// Consumer for contacts, earliest and is_free: filters, decisions in lanes, then the undecided pairs one by one.
#pragma once
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
  void consume(PairKind kind, PairBuffer& pairs) override;
  std::uint64_t memory_bytes() const { return found_.memory_bytes(); }

 private:
  /// Contacts that begin later cannot change the answer. Below 0 where no contact can: lanes then find none.
  double latest() const { return found_.bound().latest(); }
  /// Removes pairs that groups or the caller's filter exclude, or that can no longer change the answer.
  void leave_out_unwanted(PairKind kind, PairBuffer& pairs);
  /// Ends each pair's time at the latest one of interest for its bodies. The slab clip then removes pairs that come
  /// later.
  void shorten_times(PairKind kind, PairBuffer& pairs);
  void add(PairKind kind, const PairVertices& vertices, const DecidedPair& pair);
  /// `places`: of the pairs that lanes left undecided.
  void decide_left(PairKind kind, const PairBuffer& pairs, std::span<const std::int32_t> places);

  ContactCollector found_;
};

}  // namespace tamis

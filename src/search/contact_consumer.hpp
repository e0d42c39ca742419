// Decides pairs of a step: slab clip, DNF and NCF, roots in lanes, and one by one what those leave undecided; with a
// separation axes that turn and distances in place of DNF, NCF and roots.
#pragma once
#include "query/contact_collector.hpp"
#include "search/pair_stream.hpp"

namespace tamis {

class ContactConsumer final : public PairConsumer {
 public:
  static constexpr bool kHoldsPairsBack = true;
  using Asked = const ContactCollector;

  using PairConsumer::PairConsumer;

  /// Of the answer, which has begun.
  void begin(const ContactCollector& answer) {
    PairConsumer::begin(answer.query());
    found_.begin(answer.query(), answer.bound());
    found_.learn(answer);
  }
  ContactCollector& found() { return found_; }

  bool wants(PairKind kind) const override { return found_.wants(kind); }
  SearchKernel kernel(PairKind kind) const override { return thread().kernels.of(kind).search; }
  void consume(PairKind kind) override;
  std::uint64_t memory_bytes() const { return found_.memory_bytes(); }

 private:
  /// Before any work: what the caller's filter, or what is known already, leaves out.
  void leave_out_unwanted(PairKind kind);
  void decide_singly(PairKind kind, const PairVertices& vertices);

  ContactCollector found_;
};

}  // namespace tamis

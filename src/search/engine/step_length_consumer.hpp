// Consumer for step lengths: gaps along axes that turn, then along fixed axes, then the remaining pairs one by one.
#pragma once
#include <vector>

#include "numbers/held_bytes.hpp"
#include "search/bounds/shared_motion.hpp"
#include "search/engine/pair_stream.hpp"
#include "search/query/bound.hpp"
#include "search/query/step_limit.hpp"

namespace tamis {

/// Shared by the threads. `bound`: the earliest known time when a pair ends the step.
struct StepLengthQuery {
  const Query& query;
  double fraction;
  bool lists_all;                   ///< all pairs that end the step are listed: the bound is not lowered
  float spread = 0;                 ///< as in PackedMotion
  SharedMotion shared_motion = {};  ///< the motion that is taken off residuals
  double separation = 0;            ///< the largest of any pair, in the coordinates of the boxes
  Bound bound = {};

  /// The rule for pairs that may still end the step first, in time or in the order of contacts. Its limit is later than
  /// the bound by 2^-15 of it. That covers the rounding of the limit and of the searches in floats, and the loss of
  /// single pairs' times (2^-18, keeps_distance_until). So no pair is skipped that might have the same time as the
  /// first. The order of the search changes nothing.
  KeepRule rule() const;

 private:
  ClearanceBounds clearance_bounds(double until) const;
};

class StepLengthConsumer final : public PairStream {
 public:
  using Shared = StepLengthQuery;

  using PairStream::PairStream;

  void begin(StepLengthQuery& shared);
  const StepLimit& limit() const { return limit_; }
  /// All pairs that end the step, in no order, if StepLengthQuery::lists_all.
  const std::vector<StepLimit>& ends() const { return ends_; }

  bool wants(PairKind kind) const override { return !limit_.rules_out(kind); }
  SearchKernel kernel(PairKind kind) const override { return thread().kernels.of(kind).search_step_ends; }
  void set_limits(Search& search) const override { search.keep = shared_->rule(); }
  void consume(PairKind kind, PairBuffer& pairs) override;
  std::uint64_t memory_bytes() const { return held_bytes(ends_); }

 private:
  void decide(PairKind kind, const PairVertices& vertices);

  StepLengthQuery* shared_ = nullptr;
  StepLimit limit_;
  std::vector<StepLimit> ends_;
};

}  // namespace tamis

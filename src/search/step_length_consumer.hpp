// Finds the pair that ends the step first: gaps on axes that turn, then on axes that stay, and one by one what those
// leave.
#pragma once
#include <vector>

#include "bounds/shared_motion.hpp"
#include "numerics/held_bytes.hpp"
#include "query/bound.hpp"
#include "query/step_limit.hpp"
#include "search/pair_stream.hpp"

namespace tamis {

/// What the threads share. The bound: the first time found so far at which a pair ends the step.
struct StepLengthQuery {
  const Query& query;
  double fraction;
  bool lists_all;                      ///< every pair that ends the step is of interest: the bound stays
  float spread = 0;                    ///< as in PackedMotion
  SharedMotion::Stretch stretch = {};  ///< of the motion beside which the trees have residuals
  double separation = 0;               ///< of any pair at most, in the coordinates of the boxes
  Bound bound = {};

  /// Which pairs may still end the step first, in time or in the order of contacts. Until a time later by 2^-15, which
  /// covers its own rounding, that of the searches in floats, and what the times of single pairs lose to it (2^-18,
  /// keeps_distance_until): so a pair is never left out that might have had the same time as the first, and the order
  /// of the search changes nothing.
  KeepRule rule() const;

 private:
  ClearanceBounds clearance_bounds(double until) const;
};

class StepLengthConsumer final : public PairStream {
 public:
  static constexpr bool kHoldsPairsBack = false;
  using Shared = StepLengthQuery;

  using PairStream::PairStream;

  void begin(StepLengthQuery& shared);
  const StepLimit& limit() const { return limit_; }
  /// If the question lists all, in no order.
  const std::vector<StepLimit>& ends() const { return ends_; }

  bool wants(PairKind kind) const override { return !limit_.rules_out(kind); }
  SearchKernel kernel(PairKind kind) const override { return thread().kernels.of(kind).search_step_ends; }
  void set_limits(Search& search) const override { search.keep = shared_->rule(); }
  void consume(PairKind kind) override;
  std::uint64_t memory_bytes() const { return held_bytes(ends_); }

 private:
  void decide(PairKind kind, const PairVertices& vertices);

  StepLengthQuery* shared_ = nullptr;
  StepLimit limit_;
  std::vector<StepLimit> ends_;
};

}  // namespace tamis

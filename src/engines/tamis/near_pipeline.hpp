// One thread's way from pairs of blocks to the pair that ends the step first: search, gap on constant axes, and one by
// one what those leave.
#pragma once
#include <atomic>
#include <memory>
#include <vector>

#include "bounds/shared_motion.hpp"
#include "engines/step_limit.hpp"
#include "engines/stopwatch.hpp"
#include "kernels/kernels.hpp"
#include "tamis/statistics.hpp"

namespace tamis {

/// What all threads share.
struct NearQuestion {
  Step step;
  double fraction = 0;
  float spread = 0;                 ///< as in PackedMotion
  SharedMotion::Stretch stretch;    ///< of the motion beside which the trees have rests
  double separation = 0;            ///< of any pair at most, in the frame of the boxes
  std::atomic<double> earliest{1};  ///< the first time found so far at which a pair ends the step
  bool lists_all = false;           ///< every pair that ends the step is of interest: `earliest` stays

  /// Which pairs may still end the step first, in time or in the order of contacts. Until a time later by 2^-15, which
  /// covers its own rounding, that of the searches in floats, and what the times of single pairs lose to it (2^-18,
  /// keeps_distance_until): so a pair is never left out that might have had the same time as the first, and the order
  /// of the search changes nothing.
  NearRule near() const;

 private:
  ReserveBounds reserve_bounds(double until) const;
};

struct NearCounts {
  StageCount boxes{"boxes"}, near{"near"};
  PrecisionCount decided_by;
  std::uint64_t nodes_visited = 0;
  double traverse = 0, filter = 0, solving = 0;  ///< seconds

  NearCounts& operator+=(const NearCounts& other);
};

class NearPipeline {
 public:
  /// Keeps references.
  NearPipeline(const Kernels& kernels, const PackedMotion& motion, const Options& options, NearQuestion& question);
  ~NearPipeline();
  NearPipeline(NearPipeline&&) noexcept;

  /// Forgets the last step; the memory stays.
  void begin();
  /// Leaf blocks first, first + stride, ... below last of `a` against all of `b`.
  void search(PairKind kind, const TreeView& a, const TreeView& b, int first, int last, int stride);
  std::uint64_t memory_bytes() const;

  const StepLimit& limit() const { return limit_; }
  /// If the question lists all, in no order.
  const std::vector<StepLimit>& ends() const { return ends_; }
  const NearCounts& counts() const { return counts_; }

 private:
  struct Buffers;

  static void flush(Search& search);
  void decide_buffered();
  void decide(const PairVertices& vertices);

  const Kernels& kernels_;
  const PackedMotion& motion_;
  const Options& options_;
  NearQuestion& question_;
  std::unique_ptr<Buffers> buffers_;
  StepLimit limit_;
  std::vector<StepLimit> ends_;
  NearCounts counts_;
  Stopwatch watch_;
};

}  // namespace tamis

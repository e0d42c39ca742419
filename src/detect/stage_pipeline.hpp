// One thread's way from pairs of blocks to contacts: search, slab clip, DNF and NCF, roots in lanes, and one by one
// what those leave open. Buffers are small and reused.
#pragma once
#include <chrono>
#include <memory>
#include <vector>

#include "kernels/kernels.hpp"
#include "tamis/detector.hpp"

namespace tamis {

/// Pairs that entered each stage, and where the time went, of one thread.
struct PipelineCounts {
  StageCount boxes{"boxes"}, slab{"slab"}, dnf{"dnf"}, ncf{"ncf"}, solve{"solve"};
  PrecisionCount decided_by;
  std::uint64_t nodes_visited = 0;
  double traverse = 0, filter = 0, solving = 0;  ///< seconds

  PipelineCounts& operator+=(const PipelineCounts& other);
  /// `wall`: seconds of the whole pass, shared out in proportion.
  void report(Statistics& statistics, double wall) const;
};

class StagePipeline {
 public:
  StagePipeline(const Kernels& kernels, const PackedMotion& motion, const Step& step, const Options& options);
  ~StagePipeline();
  StagePipeline(StagePipeline&&) noexcept;

  /// Leaf blocks [first, last) of `a` against all of `b`.
  void search(PairKind kind, const TreeView& a, const TreeView& b, int first, int last);
  /// Decides what is still in the buffers.
  void finish();

  const PipelineCounts& counts() const { return counts_; }
  const std::vector<Contact>& contacts() const { return contacts_; }

 private:
  struct Buffers;

  static void flush(Search& search);
  void decide_buffered(PairKind kind);
  void leave_out_filtered(PairKind kind);
  void solve(PairKind kind);
  void solve_singly(PairKind kind, int pair);
  /// Seconds since the last call.
  double lap();

  const Kernels& kernels_;
  const PackedMotion& motion_;
  const Step& step_;
  const Options& options_;
  std::unique_ptr<Buffers> buffers_;
  PipelineCounts counts_;
  std::vector<Contact> contacts_;
  std::chrono::steady_clock::time_point lap_start_;
};

}  // namespace tamis

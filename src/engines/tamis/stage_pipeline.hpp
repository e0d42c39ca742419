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
  /// `wall`: seconds of the whole pass, shared out in proportion. `has_filters`: DNF and NCF were stages.
  void report(Statistics& statistics, double wall, bool has_filters) const;
};

/// Leaf blocks first, first + stride, ... below last.
struct BlockRange {
  int first, last, stride;
};

class StagePipeline {
 public:
  StagePipeline(const Kernels& kernels, const PackedMotion& motion, const Options& options);
  ~StagePipeline();
  StagePipeline(StagePipeline&&) noexcept;

  /// Forgets the last step; the memory stays.
  void begin(const Step& step);
  /// Every `blocks.stride`-th leaf block of `a` against all of `b`, as far as they may touch until `t_limit`;
  /// `is_short` as in Search.
  void search(PairKind kind, const TreeView& a, const TreeView& b, const BlockRange& blocks, float t_limit,
              bool is_short);
  /// Decides what is still in the buffers.
  void finish();
  std::uint64_t memory_bytes() const;

  const PipelineCounts& counts() const { return counts_; }
  const std::vector<Contact>& contacts() const { return contacts_; }
  /// The earliest time by which a certified contact touches; 1 if there is none.
  double touching_by() const { return touching_by_; }
  /// Appends the contacts to `to`, without a copy if that is empty.
  void move_contacts_to(std::vector<Contact>& to);

 private:
  struct Buffers;

  static void flush(Search& search);
  void decide_buffered(PairKind kind);
  /// What the slab clip leaves, where a distance must be kept: strict signs prove no distance.
  void decide_within_separation(PairKind kind);
  void leave_out_filtered(PairKind kind);
  void solve(PairKind kind);
  void add(const Contact& contact);
  void solve_singly(PairKind kind, const PairBuffer& pairs, int pair);
  /// Seconds since the last call.
  double lap();

  const Kernels& kernels_;
  const PackedMotion& motion_;
  const Options& options_;
  Step step_;
  std::unique_ptr<Buffers> buffers_;
  PipelineCounts counts_;
  std::vector<Contact> contacts_;
  double touching_by_ = 1;
  std::chrono::steady_clock::time_point lap_start_;
};

}  // namespace tamis

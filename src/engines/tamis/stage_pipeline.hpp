// One thread's way from pairs of blocks to contacts: search, slab clip, DNF and NCF, roots in lanes, and one by one
// what those leave open. Buffers are small and reused.
#pragma once
#include <memory>
#include <span>

#include "engines/found_contacts.hpp"
#include "engines/stopwatch.hpp"
#include "engines/tamis/pair_list.hpp"
#include "kernels/kernels.hpp"

namespace tamis {

/// Pairs that entered each stage, and where the time went, of one thread.
struct PipelineCounts {
  StageCount boxes{"boxes"}, slab{"slab"}, apart{"apart"}, dnf{"dnf"}, ncf{"ncf"}, solve{"solve"};
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
  /// Keeps references. With `edges_of`, all questions are about that mesh's edges (of the tree `a`) and faces in one
  /// pose: a contact is that of a vertex which runs along the edge within the step, and has the edge's
  /// number.
  StagePipeline(const Kernels& kernels, const PackedMotion& motion, const Options& options,
                const Mesh* edges_of = nullptr);
  ~StagePipeline();
  StagePipeline(StagePipeline&&) noexcept;

  /// Forgets the last question; the memory stays.
  void begin(const FoundContacts& answer);
  /// Every `blocks.stride`-th leaf block of `a` against all of `b`, as far as they may touch until `t_limit`.
  void search(PairKind kind, const TreeView& a, const TreeView& b, const BlockRange& blocks, float t_limit);
  /// The pairs first to last of a list, as far as they may touch at some time of `when`, by the list, and until
  /// `t_limit`, by this question.
  void search(PairKind kind, const PairList& pairs, std::size_t first, std::size_t last,
              const TimeInterval<float>& when, float t_limit);
  /// Decides what is still in the buffers.
  void finish();
  /// Of the question `candidates`: what the slab clip leaves, and where only crossings count DNF.
  PairList& candidates(PairKind kind) { return candidates_[static_cast<std::size_t>(kind)]; }
  std::uint64_t memory_bytes() const;

  const PipelineCounts& counts() const { return counts_; }
  FoundContacts& found() { return found_; }

 private:
  struct Buffers;

  const PairKernels& stages_of(PairKind kind) const { return edges_of_ ? kernels_.along_edges : kernels_.of(kind); }
  static void flush(Search& search);
  void decide_buffered(PairKind kind);
  /// What the slab clip leaves, where a distance counts and not a crossing: strict signs prove no distance. Leaves
  /// `filtered`.
  void cull_apart(PairKind kind);
  void decide_within_separation(PairKind kind);
  /// The first `count` of `solved`, which speak of `pairs`.
  void add_solved(PairKind kind, const PairBuffer& pairs, int count);
  /// Before any work: what the caller's filter, or what is known already, leaves out.
  void leave_out_unwanted(PairKind kind);
  void keep_buffered(PairKind kind);
  void solve(PairKind kind);
  void solve_singly(PairKind kind, const PairBuffer& pairs, int pair);
  /// As a contact names them, and where they are.
  PairVertices vertices_at(PairKind kind, const PairBuffer& pairs, int pair) const;
  PairPoints points_at(PairKind kind, const PairBuffer& pairs, int pair) const;

  const Kernels& kernels_;
  const PackedMotion& motion_;
  const Options& options_;
  const Mesh* const edges_of_;
  std::unique_ptr<Buffers> buffers_;
  PipelineCounts counts_;
  FoundContacts found_;
  PairList candidates_[kPairKinds];
  Stopwatch watch_;
};

}  // namespace tamis

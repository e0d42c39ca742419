// Shared by all searches of an engine: the trees, and one set of buffers a thread.
#pragma once
#include <tbb/enumerable_thread_specific.h>

#include <memory>

#include "numbers/held_bytes.hpp"
#include "numbers/raw_array.hpp"
#include "search/engine/feature_trees.hpp"
#include "search/engine/search_counts.hpp"
#include "search/query/stopwatch.hpp"

namespace tamis {

/// A pair decided by decide().
struct DecidedPair {
  PairResult result;
  bool by_integers = false;
};

/// One thread's part of a search.
struct SearchThread {
  SearchThread(const Kernels& k, const PackedMotion& m) : kernels(k), motion(m) {}

  /// Allocated when first used.
  LaneDecisions decision_lists() {
    if (!room_) room_ = make_raw<Room>();
    return room_->lists();
  }
  DecisionScratch& decision_scratch() {
    if (!scratch_) scratch_ = make_raw<DecisionScratch>();
    return *scratch_;
  }
  std::uint64_t memory_bytes() const {
    return sizeof(*this) + held_bytes(singly) + (room_ ? sizeof(Room) : 0) + (scratch_ ? sizeof(DecisionScratch) : 0);
  }

  const Kernels& kernels;
  const PackedMotion& motion;
  PairBuffer boxes;                 ///< filled by the stream: pairs whose boxes meet
  PairBuffer clipped, filtered;     ///< buffers for a stage to fill and to return
  std::vector<DecidedPair> singly;  ///< for decide_singly()
  SearchCounts counts;
  Stopwatch watch;  ///< runs since seconds were last added to the counts

 private:
  using Room = DecisionRoom<PairBuffer::kCapacity>;
  std::unique_ptr<Room> room_;
  std::unique_ptr<DecisionScratch> scratch_;
};

struct Workspace {
  /// Keeps references.
  Workspace(const Mesh& m, const Options& options)
      : mesh(m),
        kernels(tamis::kernels(options.isa)),
        trees(m, options, kernels),
        threads([this] { return std::make_unique<SearchThread>(kernels, trees.motion()); }) {}
  std::uint64_t memory_bytes() const { return held_bytes(trees, threads); }

  const Mesh& mesh;
  const Kernels& kernels;
  FeatureTrees trees;
  /// Pointers, as TBB fills the memory of each element with zeros.
  tbb::enumerable_thread_specific<std::unique_ptr<SearchThread>> threads;
};

}  // namespace tamis

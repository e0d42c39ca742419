// Shared by all searches of an engine: the trees, and one set of buffers a thread.
#pragma once
#include <memory>
#include <mutex>
#include <vector>

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
      : mesh(m), kernels(tamis::kernels(options.isa)), trees(m, options, kernels) {}
  /// The buffers of consumer number i of any search. Several threads may call this.
  SearchThread& thread(std::size_t i) {
    const std::lock_guard lock(mutex_);
    while (threads_.size() <= i) threads_.push_back(std::make_unique<SearchThread>(kernels, trees.motion()));
    return *threads_[i];
  }
  std::uint64_t memory_bytes() const { return held_bytes(trees, threads_); }

  const Mesh& mesh;
  const Kernels& kernels;
  FeatureTrees trees;

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<SearchThread>> threads_;
};

}  // namespace tamis

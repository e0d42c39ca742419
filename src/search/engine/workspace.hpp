// What all searches of an engine share: the trees, and one set of buffers a thread, whatever is asked.
#pragma once
#include <tbb/enumerable_thread_specific.h>

#include <memory>

#include "numbers/held_bytes.hpp"
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

  /// Output of the solver, and scratch for separations: allocated when first used.
  SolvedPair* solved_scratch() {
    TAMIS_ASSERT(0 <= filtered.count && filtered.count <= PairBuffer::kCapacity);
    if (!solved) solved = std::make_unique_for_overwrite<SolvedPair[]>(PairBuffer::kCapacity);
    return solved.get();
  }
  WithinScratch& within_scratch() {
    if (!within) within = std::make_unique_for_overwrite<WithinScratch>();
    return *within;
  }
  std::uint64_t memory_bytes() const {
    return sizeof(*this) + held_bytes(undecided, decided) + (solved ? PairBuffer::kCapacity * sizeof(SolvedPair) : 0) +
           (within ? sizeof(WithinScratch) : 0);
  }

  const Kernels& kernels;
  const PackedMotion& motion;
  PairBuffer boxes;              ///< what the stream fills: pairs whose boxes meet
  PairBuffer clipped, filtered;  ///< what stages leave
  std::unique_ptr<SolvedPair[]> solved;
  std::unique_ptr<WithinScratch> within;
  std::vector<int> undecided;        ///< places in `filtered` that lanes leave undecided
  std::vector<DecidedPair> decided;  ///< of these pairs
  SearchCounts counts;
  Stopwatch watch;  ///< runs since seconds were last added to the counts
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

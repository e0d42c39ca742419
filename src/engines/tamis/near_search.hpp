// What is near at rest: search of the trees, closest points in lanes, and in integers where doubles do not tell; then
// the pairs in their order, and what is to be said of each.
#pragma once
#include <tbb/enumerable_thread_specific.h>

#include <array>

#include "engines/near_order.hpp"
#include "engines/tamis/feature_trees.hpp"
#include "engines/tamis/near_finder.hpp"
#include "tamis/near.hpp"

namespace tamis {

class NearSearch {
 public:
  /// Keeps references.
  NearSearch(const Mesh& mesh, const Options& options, const Kernels& kernels, FeatureTrees& trees);

  /// As Engine::find_near.
  void find(const Positions& positions, const Separations& separations, std::vector<NearPair>& pairs,
            Statistics& statistics);
  std::uint64_t memory_bytes() const;

 private:
  using Lists = std::array<std::vector<PairVertices>, kPairKinds>;

  void search(PairKind kind, const TreeView& a, const TreeView& b);
  /// Puts what the threads found into one list a kind, in order.
  void gather(Statistics& statistics, double seconds);
  void describe(std::vector<NearPair>& pairs);

  const Mesh& mesh_;
  const Options& options_;
  const Kernels& kernels_;
  FeatureTrees& trees_;
  Step step_;
  Lists lists_;  ///< [kind]: in order, once all threads have searched
  NearOrder order_;
  tbb::enumerable_thread_specific<NearFinder> finders_;
};

}  // namespace tamis

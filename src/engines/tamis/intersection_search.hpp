// Which edges pass through triangles, or touch them, in one pose? A vertex that runs along the edge within a step meets
// every triangle that the edge meets: so that this is a question of vertex-face contacts, and decided as they are.
#pragma once
#include <vector>

#include "engines/engine.hpp"
#include "engines/tamis/feature_trees.hpp"
#include "engines/tamis/pipelines.hpp"

namespace tamis {

class IntersectionSearch {
 public:
  /// Keeps references.
  IntersectionSearch(const Mesh& mesh, const Options& options, const Kernels& kernels, FeatureTrees& trees);

  /// As Engine::find_intersections.
  void find(const Positions& positions, Intersections wanted, std::vector<Intersection>& found, Statistics& statistics);
  std::uint64_t memory_bytes() const;

 private:
  void search();
  Intersection intersection_of(const Contact& contact) const;

  const Mesh& mesh_;
  const Options options_;  ///< of the question about such vertices
  const Kernels& kernels_;
  FeatureTrees& trees_;
  FoundContacts found_;
  Pipelines pipelines_;
};

}  // namespace tamis

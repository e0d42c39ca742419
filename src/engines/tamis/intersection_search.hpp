// Which edges pass through triangles, or touch them, in one pose? A point that runs along the edge within the step
// meets every triangle that the edge meets: so that this is a question of vertex-face contacts, and decided as they
// are.
#pragma once
#include <tbb/enumerable_thread_specific.h>

#include <array>
#include <vector>

#include "bvh/block_tree.hpp"
#include "engines/tamis/stage_pipeline.hpp"
#include "tamis/near.hpp"

namespace tamis {

enum class Intersections : std::uint8_t { all, any };

/// Keeps its hierarchy from pose to pose. Serves every method but `brute`.
class IntersectionSearch {
 public:
  /// Keeps a reference to the mesh. Of the options: threads of the caller's arena, instruction set, groups.
  IntersectionSearch(const Mesh& mesh, const Options& options);

  /// By edge, then the face's vertices; `any`: at most one. Decided exactly. Adds to `statistics` as Engine::find does.
  /// REQUIRES: validated positions.
  void find(const Positions& positions, Intersections wanted, std::vector<Intersection>& found, Statistics& statistics);
  std::uint64_t memory_bytes() const;

 private:
  void place_runners(const Positions& positions);
  void update_trees(Statistics& statistics);
  void search();

  const Mesh& mesh_;
  const Options options_;  ///< of the question about the runners
  const Kernels& kernels_;
  std::vector<std::array<Index, 3>> runners_;  ///< vertex n + e runs along edge e, whose ends follow
  std::vector<Index> used_;                    ///< runners and the faces' vertices
  std::vector<Point> start_, end_;
  PackedMotion motion_;
  BlockTree runner_tree_, faces_;
  double built_area_ = 0;
  FoundContacts found_;
  tbb::enumerable_thread_specific<StagePipeline> pipelines_;
};

}  // namespace tamis

// The mesh as the search sees it: where its vertices are during a question, and a tree over each kind of feature.
#pragma once
#include <algorithm>

#include "bvh/block_tree.hpp"
#include "kernels/kernels.hpp"
#include "tamis/options.hpp"
#include "tamis/statistics.hpp"
#include "topology/loose_features.hpp"

namespace tamis {

/// Kept from question to question.
class FeatureTrees {
 public:
  /// Keeps references: mesh and options must outlive it. Whatever throws Cancelled leaves trees that the next question
  /// can use.
  FeatureTrees(const Mesh& mesh, const Options& options, const Kernels& kernels);
  FeatureTrees(const FeatureTrees&) = delete;
  FeatureTrees& operator=(const FeatureTrees&) = delete;

  // REQUIRES of all: as many positions as the mesh has vertices. REQUIRES (not checked: O(n)): a validated step.

  /// Boxes at t=0 and t=1, in the old order, or in a new one where that has become poor: nothing, where they are of
  /// this step already. Says seconds and `rebuilt`.
  void refit_or_rebuild(const Step& step, const Separations& separations, Statistics& statistics);

  /// The same in the old order, whatever the step. REQUIRES: a refit_or_rebuild() before that ended.
  void refit_for(const Step& step, const Separations& separations);
  /// Vertices alone: boxes are left as they are, of another step, and must not be searched. REQUIRES: an update()
  /// before that ended.
  void load_vertices(const Step& step, const Separations& separations, Statistics& statistics);
  /// Are the boxes, and the vertices, those of this step? By where its positions stand in memory, and by one of them.
  bool are_of(const Step& step) const;
  /// What the displacements of each feature have besides a motion they share, for the questions that ask. REQUIRES:
  /// are_of(step).
  void fit_residuals(const Step& step, const SharedMotion& shared);

  /// Of the largest of the trees that make pairs.
  int most_leaf_blocks() const { return std::max(points_.view().leaf_blocks, edges_.view().leaf_blocks); }
  TreeView points() const { return points_.view(); }
  TreeView edges() const { return edges_.view(); }
  TreeView faces() const { return faces_.view(); }
  /// f(kind, a, b): the trees whose features make the pairs of each kind there is. Loose points meet loose edges, and
  /// each other: all other pairs of closed features are among those of faces and of edges.
  template <class F>
  void for_each_kind(const F& f) const {
    f(PairKind::vertex_face, points_.view(), faces_.view());
    f(PairKind::edge_edge, edges_.view(), edges_.view());
    if (loose_.points.empty()) return;
    if (!loose_.edges.empty()) f(PairKind::vertex_edge, loose_points_.view(), loose_edges_.view());
    f(PairKind::vertex_vertex, loose_points_.view(), loose_points_.view());
  }

  const PackedMotion& motion() const { return motion_; }
  std::uint64_t memory_bytes() const;

 private:
  void update_trees(Statistics& statistics);
  void refit_trees();
  /// Leaves boxes of another step unless the vertices are where they were.
  void assign(const Step& step, const Separations& separations);

  const Mesh& mesh_;
  const Options& options_;
  const Kernels& kernels_;
  PackedMotion motion_;
  Step assigned_;  ///< where the vertices are from
  const LooseFeatures loose_;
  BlockTree points_, edges_, faces_, loose_points_, loose_edges_;
  double built_area_ = 0, built_scale_ = 1;
  int axes_ = 3;                ///< of the order, as order_axes says
  bool are_of_motion_ = false;  ///< the boxes
};

}  // namespace tamis

// The mesh as the search sees it: where its vertices are during a question, and a tree over each kind of feature.
#pragma once
#include "bvh/block_tree.hpp"
#include "kernels/kernels.hpp"
#include "tamis/options.hpp"
#include "tamis/statistics.hpp"
#include "topology/loose_features.hpp"

namespace tamis {

/// Kept from question to question.
class FeatureTrees {
 public:
  /// Keeps references: mesh and filter must outlive it.
  FeatureTrees(const Mesh& mesh, const Kernels& kernels, const PairFilter& filter);
  FeatureTrees(const FeatureTrees&) = delete;
  FeatureTrees& operator=(const FeatureTrees&) = delete;

  /// Boxes at t=0 and t=1, in the old order, or in a new one where that has become poor. Says seconds and `rebuilt`.
  void update(const Step& step, const Separations& separations, Statistics& statistics);

  /// The same in the old order, whatever the step. REQUIRES: update() before.
  void look_at(const Step& step, const Separations& separations);
  /// Vertices alone: boxes are left as they are, of another step.
  void move_vertices(const Step& step, const Separations& separations, Statistics& statistics);
  /// What the displacements of each feature have besides a motion they share, for the questions that ask: in place of
  /// drifts, of motion and trees.
  void count_rests(const Step& step, const SharedMotion& shared);
  /// How far vertices have drifted since the positions `before`.
  const PackedMotion& count_vertex_drifts(const Step& step, const Positions& before);
  /// How often the trees have been built: blocks of one building are not those of another.
  int builds() const { return builds_; }

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

  const Mesh& mesh_;
  const Kernels& kernels_;
  PackedMotion motion_;
  const LooseFeatures loose_;
  BlockTree points_, edges_, faces_, loose_points_, loose_edges_;
  double built_area_ = 0;
  int builds_ = 0;
};

}  // namespace tamis

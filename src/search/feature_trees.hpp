// The mesh as the search sees it: where its vertices are during a question, and a tree over each kind of feature.
#pragma once
#include <algorithm>
#include <array>
#include <optional>

#include "bvh/block_tree.hpp"
#include "kernels/kernels.hpp"
#include "numerics/held_bytes.hpp"
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

  /// Boxes at t=0 and t=1, in the old order, or in a new one where that has become poor, or was chosen for other
  /// questions: nothing, where they are of this step already, in an order that serves. Says seconds and `rebuilt`.
  void refit_or_rebuild(const Step& step, const Separations& separations, LooksAt looks_at, Statistics& statistics);

  /// The same in the old order, whatever the step. REQUIRES: a refit_or_rebuild() before that ended.
  void refit_for(const Step& step, const Separations& separations);
  /// Vertices alone: boxes are left as they are, of another step if of any, and must not be searched.
  void load_vertices(const Step& step, const Separations& separations, Statistics& statistics);
  /// Are the boxes, and the vertices, those of this step? By where its positions stand in memory, and by one of them.
  bool are_of(const Step& step) const;
  /// What the displacements of each feature have besides a motion they share, for the questions that ask. REQUIRES:
  /// are_of(step).
  void fit_residuals(const Step& step, const SharedMotion& shared);
  /// From now until the next step is told, searches leave out blocks of features without a vertex that is not 0 here,
  /// with each other. Empty: none. REQUIRES: as above, or empty.
  void mark(std::span<const std::uint8_t> of_vertex);

  /// A search of these trees has visited so many pairs of nodes.
  void add_search(std::uint64_t nodes) {
    if (is_doubtful_) nodes_in_doubt_ += nodes;
  }

  /// Of the trees that make pairs, together; and of the largest.
  int leaf_blocks() const { return points_.view().leaf_blocks + edges_.view().leaf_blocks; }
  int most_leaf_blocks() const { return std::max(points_.view().leaf_blocks, edges_.view().leaf_blocks); }
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
  std::uint64_t memory_bytes() const { return held_bytes(motion_, loose_.points, loose_.edges, trees()); }

 private:
  void refit_trees();
  void update_trees(LooksAt looks_at, Statistics& statistics);
  /// Does the order that the trees have serve the step that their boxes are of, and the question?
  bool is_order_good(LooksAt looks_at);
  bool is_order_of_start() const { return axes_.time == 0; }
  OrderAxes best_axes(LooksAt looks_at) const;
  BlockTree::Areas areas() const;
  std::array<BlockTree*, 5> trees() { return {&points_, &edges_, &faces_, &loose_points_, &loose_edges_}; }
  std::array<const BlockTree*, 5> trees() const { return {&points_, &edges_, &faces_, &loose_points_, &loose_edges_}; }
  /// Leaves boxes of another step unless the vertices are where they were.
  void assign(const Step& step, const Separations& separations);

  const Mesh& mesh_;
  const Options& options_;
  const Kernels& kernels_;
  PackedMotion motion_;
  Step assigned_;  ///< where the vertices are from
  const LooseFeatures loose_;
  BlockTree points_, edges_, faces_, loose_points_, loose_edges_;
  OrderAxes axes_;
  std::optional<BlockTree::Areas> built_areas_;  ///< when they were built; nothing: they are not
  double built_scale_ = 1;
  bool is_doubtful_ = false;          ///< an order by how far features go, of a step that goes nowhere near as far
  std::uint64_t nodes_in_doubt_ = 0;  ///< visited since the trees were built, with steps of that kind
  int start_in_row_ = 0;              ///< the last questions, that looked at less than the whole step
  bool are_of_motion_ = false;        ///< the boxes
};

}  // namespace tamis

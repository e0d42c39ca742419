// The mesh as the search sees it: the packed vertices of the current step, and a tree over each kind of feature.
#pragma once
#include <algorithm>
#include <array>
#include <optional>

#include "numbers/held_bytes.hpp"
#include "search/bvh/block_tree.hpp"
#include "search/kernels/kernels.hpp"
#include "search/topology/loose_features.hpp"
#include "tamis/options.hpp"
#include "tamis/statistics.hpp"

namespace tamis {

/// Kept from question to question.
class FeatureTrees {
 public:
  /// Keeps references: mesh and options must outlive it. A call that throws Cancelled leaves trees that the next
  /// question can use.
  FeatureTrees(const Mesh& mesh, const Options& options, const Kernels& kernels);
  FeatureTrees(const FeatureTrees&) = delete;
  FeatureTrees& operator=(const FeatureTrees&) = delete;

  // REQUIRES, all: as many positions as the mesh has vertices. REQUIRES (not checked: O(n)): a validated step.

  // `frame`: of the whole scene, if the mesh is a part of it; null: of the mesh.

  /// Gives the trees the boxes of this step: refits them, or rebuilds them where their order has become poor or was
  /// chosen for other questions. Does nothing if they are current, in an order that serves. Adds seconds and `rebuilt`.
  void refit_or_rebuild(const Step& step, const Separations& separations, const BoxFrame* frame, LooksAt looks_at,
                        Statistics& statistics);

  /// Refits to any step in the old order. REQUIRES: an earlier refit_or_rebuild() that ended.
  void refit_for(const Step& step, const Separations& separations, const BoxFrame* frame);
  /// Loads the vertices alone. The boxes stay as for an earlier step, if any, and must not be searched.
  void load_vertices(const Step& step, const Separations& separations, const BoxFrame* frame, Statistics& statistics);
  /// True if boxes and vertices belong to this step, judged by one vertex.
  bool are_of(const Step& step) const;
  /// Refits the boxes of residuals: displacements less a shared motion. REQUIRES: current boxes.
  void refit_residuals(const SharedMotion& shared);
  /// Marks the vertices that are not 0 here. Until another step is loaded, searches skip pairs of blocks without a
  /// marked vertex. Empty: they skip none. REQUIRES: current boxes, or empty.
  void mark(std::span<const std::uint8_t> of_vertex);

  /// Takes note of the pairs of nodes that a search visited.
  void add_search(std::uint64_t nodes) {
    if (is_order_in_doubt_) nodes_in_doubt_ += nodes;
  }

  /// Leaf blocks of the trees that searches start from: the sum, and the larger number.
  int leaf_blocks() const { return points_.view().leaf_blocks + edges_.view().leaf_blocks; }
  int most_leaf_blocks() const { return std::max(points_.view().leaf_blocks, edges_.view().leaf_blocks); }
  TreeView edges() const { return edges_.view(); }
  TreeView faces() const { return faces_.view(); }
  /// Calls f(kind, a, b) for each kind that the mesh has pairs of, with the trees of its two features.
  template <class F>
  void for_each_kind(const F& f) const {
    for (std::size_t i = 0; i < kPairKinds; ++i)
      if (const auto& [a, b] = trees_of(static_cast<PairKind>(i)); a->feature_count() > 0 && b->feature_count() > 0)
        f(static_cast<PairKind>(i), a->view(), b->view());
  }

  const PackedMotion& motion() const { return motion_; }
  std::uint64_t memory_bytes() const { return held_bytes(motion_, loose_.points, loose_.edges, trees()); }

 private:
  void refit_trees();
  void update_trees(LooksAt looks_at, Statistics& statistics);
  /// True if the order of the trees serves the current step, and the question.
  bool is_order_good(LooksAt looks_at);
  bool is_order_of_start() const { return axes_.time == 0; }
  OrderAxes best_axes(LooksAt looks_at) const;
  BlockTree::Areas areas() const;
  /// The trees of a kind's two features. Loose points are searched against loose edges and each other. All other
  /// contacts of points and edges are contacts of faces or of edges.
  std::array<const BlockTree*, 2> trees_of(PairKind kind) const;
  std::array<BlockTree*, 5> trees() { return {&points_, &edges_, &faces_, &loose_points_, &loose_edges_}; }
  std::array<const BlockTree*, 5> trees() const { return {&points_, &edges_, &faces_, &loose_points_, &loose_edges_}; }
  /// Calls f(tree) for each tree, in parallel if the mesh is large.
  template <class F>
  void for_each_tree(const F& f);
  /// Loads the vertices; the boxes stay current only if no vertex has changed.
  void assign(const Step& step, const Separations& separations, const BoxFrame* frame);

  const Mesh& mesh_;
  const Options& options_;
  const Kernels& kernels_;
  PackedMotion motion_;
  const LooseFeatures loose_;
  BlockTree points_, edges_, faces_, loose_points_, loose_edges_;
  OrderAxes axes_;
  std::optional<BlockTree::Areas> built_areas_;  ///< at the last build; nothing before the first
  double built_scale_ = 1;
  bool is_order_in_doubt_ = false;    ///< the order is by displacements, but the current step is not long
  std::uint64_t nodes_in_doubt_ = 0;  ///< visited for such steps since the trees were built
  int start_in_row_ = 0;              ///< questions in a row that were not about the whole step
  bool boxes_are_current_ = false;    ///< they are of the vertices that were loaded last
};

}  // namespace tamis

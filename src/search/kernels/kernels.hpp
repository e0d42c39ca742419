// The hot loops, compiled once per instruction set and chosen at run time. Plain pointers only. A kernel object must
// not emit code of shared templates. The linker could pick it for a machine without that instruction set.
#pragma once
#include <cstddef>
#include <cstdint>

#include "search/bvh/block_tree.hpp"
#include "tamis/contact.hpp"
#include "tamis/options.hpp"
#include "tamis/pair.hpp"
#include "tamis/proximity.hpp"

namespace tamis {

/// Pairs of features between two stages: corners in Contact's order, and the part of the step when they may touch. An
/// edge and a face in one pose are stored as a vertex and a face. The vertex starts at corner 0, runs along the edge
/// within the step, and ends at corner 4. Other pairs have no corner 4. Kernels may read up to kPadding entries past
/// `count`, without using them, and overwrite them with valid vertices.
struct PairBuffer {
  static constexpr int kPadding = 16;
  static constexpr int kCapacity = 2048;
  static constexpr int kSize = kCapacity + kPadding;
  int count = 0;
  std::int32_t corner[5][kSize] = {};
  float t_in[kSize] = {};
  float t_out[kSize] = {};
};

/// A pair of a buffer that touches.
struct TouchingPair {
  std::int32_t pair;  ///< its place in the buffer
  PairResult result;
};

/// What lanes found of the pairs of a buffer. A pair in neither list is proven free. REQUIRES (not checked: lanes): in
/// each list room for as many pairs as the buffer has.
struct LaneDecisions {
  TouchingPair* touching;
  std::int32_t* undecided;  ///< places in the buffer of the pairs that are left to decide()
  int touching_count = 0, undecided_count = 0;
};

/// Room for the decisions on this many pairs.
template <int pairs>
struct DecisionRoom {
  LaneDecisions lists() { return {touching, undecided}; }

  TouchingPair touching[pairs];
  std::int32_t undecided[pairs];
};

/// Pairs that advance towards the time at which they come within their separation (pair/narrow/advancement.hpp): proven
/// apart until `now`. Times after `until` do not count. Beyond `count` only vertices must be valid; the other arrays
/// are not initialized.
struct AdvanceBuffer {
  PairBuffer pairs;
  std::int32_t places[PairBuffer::kSize];  ///< in their buffer or list
  double now[PairBuffer::kSize];
  double until[PairBuffer::kSize];
};

/// Scratch of the kernels that decide pairs.
struct DecisionScratch {
  AdvanceBuffer moving, touching;
};

/// Bound of the clearance of a pair within two boxes that can end the step, in the frame of the boxes: clearance^2 <=
/// per_residual2 residual^2 + per_size2 size^2 + fixed2. `residual` is the largest difference of the boxes' residuals
/// (SharedMotion). size^2 is at least half of the square of both boxes' joint extent, at t=0 and at t=1. All rounded
/// up.
struct ClearanceBounds {
  float per_residual2, per_size2, fixed2;
  float stretch2;  ///< size^2 = stretch2 far^2 + residual^2, where far is the largest distance of corners at t=0
};

/// Which pairs may end the step before `t_limit`, where each must keep a fraction of its distance beyond the separation
/// (pair/distance/kept_gap.hpp).
struct KeepRule {
  float fraction;         ///< rounded up
  float reach_per_speed;  ///< t_limit / (1 - fraction), rounded up
  float t_limit;          ///< rounded up; may exceed 1
  float spread;           ///< by how much the residuals of features but outliers differ, summed over the axes
  ClearanceBounds clearance;
};

/// One thread's search over one pair of trees.
struct Search {
  TreeView a, b;  ///< vf: points, faces; ee: edges, edges
  /// Contacts that begin after this time do not count. A float, so the stages in floats do not round it.
  float t_limit = 1;
  bool has_outliers = false;  ///< BoxFrame::has_outliers
  KeepRule keep{};            ///< for search_step_ends, instead of t_limit
  /// For searches at rest: by how much two boxes together are wider than their features.
  float widened = 0;
  PairBuffer* pairs = nullptr;
  /// Called when `pairs` cannot take sixteen pairs more; must empty it.
  void (*flush)(Search&) = nullptr;
  void* context = nullptr;
  std::uint64_t nodes_visited = 0;
};

/// Searches from one leaf block of `a`.
using SearchKernel = void (*)(Search& search, int block);

/// The vertices of a step in the layout of Positions. A stride is the distance to the next vertex, in doubles.
struct StepRows {
  const double *start, *end;
  std::ptrdiff_t start_stride, end_stride;
};

/// The kernels of one kind of pairs. Null where the kind has no use for one. Kernels that cull overwrite `out` with the
/// pairs that they leave.
struct PairKernels {
  /// Finds all pairs of a feature in leaf block `block` of `a` with a feature of `b` that share no vertex and whose
  /// moving boxes meet. Also finds some more pairs, depending on how features are put into blocks (box_overlap.hpp).
  /// Edges are searched against blocks from `block` on, each pair once. Loose edges and points are searched like faces,
  /// their last vertex repeated.
  SearchKernel search = nullptr;
  /// The same for boxes at t=0. Two boxes together are widened by search.widened.
  SearchKernel search_at_rest = nullptr;
  /// The same for pairs that may end the step by search.keep. REQUIRES: trees with residuals.
  SearchKernel search_step_ends = nullptr;
  /// Culls pairs that cannot end the step by the rule between t=0 and their t_out. The others go to `out`. `pairs` is
  /// overwritten. For kinds that can cross.
  void (*may_end_step)(const MotionView& motion, const KeepRule& rule, PairBuffer& pairs, PairBuffer& out) = nullptr;
  /// Slab clip: culls pairs that stay farther apart than their separation. The others go to `out`, with the times left.
  void (*slab)(const MotionView& motion, const PairBuffer& in, PairBuffer& out) = nullptr;
  /// DNF, then NCF, on each pair's times. Returns how many pairs DNF left to NCF. For kinds that can cross, as the
  /// next.
  int (*filter)(const MotionView& motion, const PairBuffer& in, PairBuffer& out) = nullptr;
  /// Culls pairs that are proven farther apart than their separation during their times. The proof is one axis that
  /// turns with the pair, or one in each of four parts of the time. `pairs` is overwritten.
  void (*cull_apart)(const MotionView& motion, PairBuffer& pairs, PairBuffer& out) = nullptr;
  /// Decides pairs on the whole step: by crossings (pair/narrow/clipped_crossing.hpp), or with a separation by
  /// advancement (advance_lanes.hpp). The answer depends on the pair alone, and has the bits of decide(). Pairs whose
  /// contact begins after `latest` count as free. Pairs with coordinates that are not finite are left undecided.
  void (*decide)(const MotionView& motion, double latest, const PairBuffer& in, DecisionScratch& scratch,
                 LaneDecisions& out) = nullptr;
  /// The same for vertices in the layout of Positions.
  void (*decide_rows)(const StepRows& vertices, double min_separation, double latest, const PairBuffer& in,
                      DecisionScratch& scratch, LaneDecisions& out) = nullptr;
  /// At rest: writes the pairs within their separation to `near`, and to `unsure` the pairs that may be within it, but
  /// whose distance doubles do not give sharply enough.
  void (*find_within_at_rest)(const MotionView& motion, const PairBuffer& in, PairBuffer& near,
                              PairBuffer& unsure) = nullptr;
  /// At rest: writes a NearPair for each pair of the buffer. The distance is NaN where doubles do not give it sharply
  /// enough.
  void (*measure)(const PackedVertex* vertices, const PairBuffer& in, NearPair* out) = nullptr;
};

struct Kernels {
  Isa isa;
  BoundLeaf bound_leaf;
  PairKernels of_kind[kPairKinds];
  /// For edges of `a` that meet faces of `b` in one pose, by boxes at t=0. PairBuffer says how such a pair moves.
  PairKernels along_edges;

  const PairKernels& of(PairKind kind) const { return of_kind[static_cast<std::size_t>(kind)]; }
};

/// The kernels of `isa`; throws InvalidOptions if this machine or build has none. `best`: the widest there is.
const Kernels& kernels(Isa isa);

}  // namespace tamis

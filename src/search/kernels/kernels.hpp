// The hot loops, compiled once per instruction set and chosen at run time. Plain pointers only: a kernel object must
// not emit code of shared templates, which the linker could then pick for a machine without that instruction set.
#pragma once
#include <cstddef>
#include <cstdint>

#include "search/bvh/block_tree.hpp"
#include "tamis/contact.hpp"
#include "tamis/options.hpp"
#include "tamis/pair.hpp"
#include "tamis/proximity.hpp"

namespace tamis {

/// Pairs of features between two stages: corners in Contact's order, and the part of the step in which they may touch.
/// An edge and a face in one pose are stored as a vertex and a face: the vertex starts at corner 0, runs along the edge
/// within the step, and ends at corner 4, which other pairs do not have. Kernels may read up to kPadding entries past
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

/// What the solver in lanes found of one pair of a buffer.
struct SolvedPair {
  std::int32_t pair;  ///< its place in the buffer
  bool is_decided;    ///< false: to be decided singly
  PairResult result;  ///< if it is decided; a normal of NaN leaves the place to integers (contact_normal.hpp)
};

/// Pairs that advance towards the time at which they come within their separation (pair/narrow/advancement.hpp): proven
/// apart until `now`; times after `until` are not asked about. Beyond `count` only vertices must be valid; the other
/// arrays are not initialized.
struct AdvanceBuffer {
  PairBuffer pairs;
  std::int32_t places[PairBuffer::kSize];  ///< in the buffer or the list that they came from
  double now[PairBuffer::kSize];
  double until[PairBuffer::kSize];
};

/// Scratch of the kernels that decide pairs within a separation.
struct WithinScratch {
  AdvanceBuffer moving, touching;
};

/// Bound of the clearance of a pair within two boxes that can end the step, in the frame of the boxes:
/// clearance^2 <= per_residual2 residual^2 + per_size2 size^2 + fixed2, where `residual` is the largest difference of
/// the boxes' residuals (SharedMotion), and size^2 is at least half of the square of both boxes' joint extent, at t=0
/// and at t=1. All rounded up.
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
  /// Contacts that begin after this time are of no interest. A float, so that the stages in floats do not round it.
  float t_limit = 1;
  bool has_outliers = false;  ///< BoxFrame::has_outliers
  KeepRule keep{};            ///< for search_step_ends, in place of t_limit
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

/// The vertices of a step in the layout of Positions; a stride is the distance to the next vertex, in doubles.
struct StepRows {
  const double *start, *end;
  std::ptrdiff_t start_stride, end_stride;
};

/// The input of decide_list beside the pairs.
struct ListedPairs {
  StepRows vertices;
  const std::int32_t* places;  ///< of the buffer's pairs in the list
  double min_separation = 0;
  double latest = 1;                ///< no contact that begins later is asked for
  WithinScratch* within = nullptr;  ///< used with a separation, and for kinds that cannot cross
};

/// The kernels of one kind of pairs; null where the kind has no use for one. Kernels that cull overwrite `out` with the
/// pairs that they leave.
struct PairKernels {
  /// Finds all pairs of a feature in leaf block `block` of `a` with a feature of `b` that share no vertex and whose
  /// moving boxes meet; and some more pairs, depending on how features are put into blocks (box_overlap.hpp). Edges are
  /// searched against blocks from `block` on, each pair once. Loose edges and points are searched like faces, their
  /// last vertex repeated.
  SearchKernel search = nullptr;
  /// The same for boxes at t=0, two of which together are widened by search.widened.
  SearchKernel search_at_rest = nullptr;
  /// The same for pairs that may end the step by search.keep. REQUIRES: trees with residuals.
  SearchKernel search_step_ends = nullptr;
  /// Culls pairs that cannot end the step by the rule between t=0 and their t_out; the others go to `out`. `pairs` is
  /// overwritten. For kinds that can cross.
  void (*may_end_step)(const MotionView& motion, const KeepRule& rule, PairBuffer& pairs, PairBuffer& out) = nullptr;
  /// Slab clip: culls pairs that stay farther apart than their separation. The others go to `out`, with the times left.
  void (*slab)(const MotionView& motion, const PairBuffer& in, PairBuffer& out) = nullptr;
  /// DNF, then NCF, on each pair's times. Returns how many pairs DNF left to NCF. For kinds that can cross, as the next
  /// two.
  int (*filter)(const MotionView& motion, const PairBuffer& in, PairBuffer& out) = nullptr;
  /// DNF for deviating motions: culls pairs that cannot touch while no vertex is farther than `deviation`, along any
  /// axis, from where the motion has it.
  void (*filter_deviating)(const MotionView& motion, double deviation, const PairBuffer& in, PairBuffer& out) = nullptr;
  /// Roots and inside test. Writes the pairs that touch or are undecided, returns their number; `rest` is scratch.
  int (*solve)(const MotionView& motion, const PairBuffer& in, PairBuffer& rest, SolvedPair* out) = nullptr;
  /// Culls pairs that are proven farther apart than their separation during their times: by one axis that turns with
  /// the pair, or by one in each of four parts of the time. `pairs` is overwritten.
  void (*cull_apart)(const MotionView& motion, PairBuffer& pairs, PairBuffer& out) = nullptr;
  /// Finds when pairs come within their separation, on the whole step, with the bits of decide(). Writes the pairs that
  /// come within it until `latest`, and the undecided pairs; returns the number of both.
  int (*come_within)(const MotionView& motion, double latest, const PairBuffer& in, WithinScratch& scratch,
                     SolvedPair* out) = nullptr;
  /// At rest: writes the pairs within their separation to `near`, and to `unsure` the pairs that may be within it, but
  /// whose distance doubles do not give sharply enough.
  void (*find_within_at_rest)(const MotionView& motion, const PairBuffer& in, PairBuffer& near,
                              PairBuffer& unsure) = nullptr;
  /// At rest: writes a NearPair for each pair of the buffer; the distance is NaN where doubles do not give it sharply
  /// enough.
  void (*measure)(const PackedVertex* vertices, const PairBuffer& in, NearPair* out) = nullptr;
  /// Decides pairs of a list on the whole step, each with the bits of decide(), as far as crossings in doubles
  /// (pair/narrow/clipped_crossing.hpp) or, with a separation, advancement (advance_lanes.hpp) decide them. Writes
  /// results[places[i]]. Writes the places of the other pairs, which are for decide() or have coordinates that are not
  /// finite, to `undecided`, and returns their number. `rest` is scratch.
  int (*decide_list)(const ListedPairs& list, const PairBuffer& in, PairBuffer& rest, PairResult* results,
                     std::int32_t* undecided) = nullptr;
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

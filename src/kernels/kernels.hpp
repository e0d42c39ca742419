// The hot loops, compiled once per instruction set and chosen at run time. Plain pointers only: a kernel object must
// not emit code of shared templates, which the linker could then pick for a machine without that instruction set.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "bvh/block_tree.hpp"
#include "motion/pair_kinds.hpp"
#include "narrow/contact_rule.hpp"
#include "tamis/contact.hpp"
#include "tamis/options.hpp"
#include "tamis/pair.hpp"
#include "tamis/proximity.hpp"

namespace tamis {

/// Pairs of features on their way through the stages: corners in Contact's order, and the part of the step in which
/// they may touch. An edge and a face in one pose are a vertex and a face: the vertex starts at corner 0, runs along
/// the edge within the step, and ends at corner 4, which other pairs do not have. Kernels may read (not use) and
/// overwrite, with valid vertices, up to kPadding entries past `count`.
struct PairBuffer {
  static constexpr int kPadding = 16;
  static constexpr int kCapacity = 2048;
  static constexpr int kSize = kCapacity + kPadding;
  int count = 0;
  std::int32_t corner[5][kSize] = {};
  float t_in[kSize] = {};
  float t_out[kSize] = {};
};

/// What the solver in lanes says of one pair of a buffer.
struct SolvedPair {
  std::int32_t pair;  ///< its place in the buffer
  bool is_decided;    ///< false: cut in time, one pair at a time
  double toi_lower, toi_upper;
  double u, v;
  double normal[3];  ///< unit; NaN where it is decided, but the place is asked of a single pair (contact_normal.hpp)
};

/// Pairs on the way to the time at which they come within their separation (narrow/advancement.hpp): proven apart until
/// `now`, and what is asked of them ends at `until`. Beyond `count` only vertices must be valid: the rest, which is as
/// large, is not initialized.
struct AdvanceBuffer {
  PairBuffer pairs;
  std::int32_t places[PairBuffer::kSize];  ///< in the buffer or the list that they came from
  double now[PairBuffer::kSize];
  double until[PairBuffer::kSize];
};

/// Which contacts are asked for.
struct WithinRule {
  PairSeparation separation;
  double latest;  ///< none that begins later
};

/// Scratch of the kernels that decide pairs within a separation.
struct WithinScratch {
  AdvanceBuffer moving, touching;
};

/// How large the clearance of a pair within two boxes may be if it can end the step, in their frame:
/// clearance^2 <= per_way2 way^2 + per_size2 size^2 + fixed2, where way is the largest difference of residuals
/// (SharedMotion) and size^2 at least half of the square of their extent together, at t=0 and t=1. All rounded up.
struct ClearanceBounds {
  float per_way2, per_size2, fixed2;
  float stretch2;  ///< size^2 = stretch2 far^2 + way^2, where far is the largest distance of corners at t=0
};

/// Which pairs may end the step before `t_limit`, where each must keep a fraction of its distance beyond the separation
/// (distance/kept_gap.hpp).
struct KeepRule {
  float fraction;  ///< rounded up
  float reach;     ///< t_limit / (1 - fraction), rounded up
  float t_limit;   ///< rounded up; may exceed 1
  float spread;    ///< of the residuals of all features: how much they differ, summed over the axes
  ClearanceBounds clearance;
};

/// The vertices of a step, and what pairs of them are kept apart by, in floats and in doubles.
struct KeepVertices {
  const BoxVertex* in_boxes;
  BoxSeparation box_separation;
  const PackedVertex* exact;
  PairSeparation separation;
};

/// One thread's search over one pair of trees.
struct Search {
  TreeView a, b;  ///< vf: points, faces; ee: edges, edges
  /// Nothing that starts after this time is of interest; a float, so that the stages in floats do not round it.
  float t_limit = 1;
  KeepRule keep{};  ///< for search_step_ends, in place of t_limit
  /// For searches at rest: by how much boxes are wider, together, than what is near.
  float widened = 0;
  PairBuffer* pairs = nullptr;
  /// Called when `pairs` cannot take sixteen pairs more; must empty it.
  void (*flush)(Search&) = nullptr;
  void* context = nullptr;
  std::uint64_t nodes_visited = 0;
};

/// Searches from one leaf block of `a`.
using SearchKernel = void (*)(Search& search, int block);

/// The vertices of a step as Positions has them: distances from one to the next in doubles.
struct StepRows {
  const double *start, *end;
  std::ptrdiff_t start_stride, end_stride;
};

/// What goes with the pairs of a list.
struct ListedPairs {
  StepRows vertices;
  const std::int32_t* places;  ///< of the pairs of the buffer in the list
  const ContactRule& rule;
  WithinScratch* within;  ///< where a separation is asked for, or a kind that cannot cross
};

/// The kernels of one type of pairs; null where the type has no use for one.
struct PairKernels {
  /// Finds the pairs of features of leaf block `block` of `a` with all of `b` whose moving boxes meet and that share
  /// no vertex, and others, which depend on how features are put into blocks (box_overlap.hpp); of edges: with the
  /// blocks from `block` on, each pair once. Loose edges and points are searched as faces are, their last vertex
  /// repeated.
  SearchKernel search = nullptr;
  /// The same of boxes at t=0 that are wider, together, by search.widened.
  SearchKernel search_at_rest = nullptr;
  /// The same of pairs that may end the step by the rule. Trees have residuals.
  SearchKernel search_step_ends = nullptr;
  /// Pairs that cannot end the step by the rule, from t=0 to their t_out, are culled. `pairs` is used up: what it holds
  /// then are those that floats could not cull. Of pairs that can cross.
  void (*may_end_step)(const KeepVertices& vertices, const KeepRule& rule, PairBuffer& pairs,
                       PairBuffer& out) = nullptr;
  /// Slab clip: pairs that stay farther apart than `separation` are culled. Survivors, with their times, go to `out`.
  void (*slab)(const BoxVertex* vertices, const BoxSeparation& separation, const PairBuffer& in,
               PairBuffer& out) = nullptr;
  /// DNF, then NCF, on what is left of the step. Returns how many pairs NCF had to look at. Of pairs that can cross, as
  /// the next two.
  int (*filter)(const PackedVertex* vertices, const PairBuffer& in, PairBuffer& out) = nullptr;
  /// DNF for motions that are not quite known: pairs that cannot touch while no vertex is farther than `deviation` from
  /// where it is here, along any axis, are culled.
  void (*filter_deviating)(const PackedVertex* vertices, double deviation, const PairBuffer& in,
                           PairBuffer& out) = nullptr;
  /// Roots and inside test. Writes the pairs that touch or are undecided, returns their number; `rest` is scratch.
  int (*solve)(const PackedVertex* vertices, const PairBuffer& in, PairBuffer& rest, SolvedPair* out) = nullptr;
  /// Pairs that one axis which turns with them, or four, prove farther apart than their separation during their times
  /// are culled. `pairs` is used up.
  void (*cull_apart)(const BoxVertex* vertices, const BoxSeparation& separation, PairBuffer& pairs,
                     PairBuffer& out) = nullptr;
  /// When do pairs come within their separation? Asked of the whole step, with the bits of decide(). Writes the pairs
  /// that do, and those left undecided; returns their number.
  int (*come_within)(const PackedVertex* vertices, const WithinRule& rule, const PairBuffer& in, WithinScratch& scratch,
                     SolvedPair* out) = nullptr;
  /// At rest: appends the pairs within their separation to `near`, and to `unsure` those that may be and whose
  /// distance doubles do not know well enough.
  void (*find_within_at_rest)(const PackedVertex* vertices, const PairSeparation& separation, const PairBuffer& in,
                              PairBuffer& near, PairBuffer& unsure) = nullptr;
  /// At rest: one NearPair for each pair of the buffer; the distance is NaN where doubles do not know it well enough.
  void (*measure)(const PackedVertex* vertices, const PairBuffer& in, NearPair* out) = nullptr;
  /// The pairs of a list, each for the whole step and by itself, as far as doubles decide it
  /// (narrow/decided_by_crossing.hpp): with the bits of decide(). Writes results[places[i]], or the place to
  /// `undecided`, whose number is returned: of pairs for decide_undecided(), or whose coordinates are not finite.
  /// `rest` is scratch.
  int (*decide_list)(const ListedPairs& list, const PairBuffer& in, PairBuffer& rest, PairResult* results,
                     std::int32_t* undecided) = nullptr;
};

struct Kernels {
  Isa isa;
  TreeKernels trees;
  PairKernels of_kind[kPairKinds];
  /// Edges of a that meet faces of b in one pose, boxes at t=0: PairBuffer says how such a pair moves.
  PairKernels along_edges;

  const PairKernels& of(PairKind kind) const { return of_kind[static_cast<std::size_t>(kind)]; }
};

/// The kernels of `isa`; throws InvalidOptions if this machine or build has none. `best`: the widest there is.
const Kernels& kernels(Isa isa);

}  // namespace tamis

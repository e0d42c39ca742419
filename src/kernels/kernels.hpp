// The hot loops, compiled once per instruction set and chosen at run time. Plain pointers only: a kernel object must
// not emit code of shared templates, which the linker could then pick for a machine without that instruction set.
#pragma once
#include <cstdint>

#include "bvh/block_tree.hpp"
#include "tamis/contact.hpp"
#include "tamis/options.hpp"

namespace tamis {

/// Pairs of features on their way through the stages: corners in Contact's order, and the part of the step in which
/// they may touch. Kernels may read (not use) and overwrite, with valid vertices, up to kPadding entries past `count`.
struct PairBuffer {
  static constexpr int kPadding = 16;
  static constexpr int kCapacity = 2048;
  static constexpr int kSize = kCapacity + kPadding;
  int count = 0;
  std::int32_t corner[4][kSize] = {};
  float t_in[kSize] = {};
  float t_out[kSize] = {};
};

/// What the solver in lanes says of one pair of a buffer.
struct SolvedPair {
  std::int32_t pair;  ///< its place in the buffer
  bool is_decided;    ///< false: cut in time, one pair at a time
  double toi_lower, toi_upper;
  double u, v;
  double normal[3];  ///< unit
};

/// One thread's search over one pair of trees.
struct Search {
  TreeView a, b;  ///< vf: points, faces; ee: edges, edges
  /// Nothing that starts after this time is of interest; a float, so that the stages in floats do not round it.
  /// For search_near, the reach: pairs of boxes at t=0 farther apart than this times the largest difference of their
  /// displacements are of no interest.
  float t_limit = 1;
  /// Until t_limit things move so little that what boxes sweep over serves as well as boxes that move.
  bool is_short = false;
  PairBuffer* pairs = nullptr;
  /// Called when `pairs` cannot take another pair of blocks; must empty it.
  void (*flush)(Search&) = nullptr;
  void* context = nullptr;
  std::uint64_t nodes_visited = 0;
};

struct Kernels {
  Isa isa;
  TreeKernels trees;
  /// Finds the pairs of features of leaf block `block` of `a` with all of `b` whose moving boxes meet and that share
  /// no vertex; ee: with the blocks from `block` on, each pair once.
  void (*search_vf)(Search& search, int block);
  void (*search_ee)(Search& search, int block);
  /// The same for boxes that hold displacements: pairs within reach. Times are not set.
  void (*search_near_vf)(Search& search, int block);
  void (*search_near_ee)(Search& search, int block);
  /// Pairs that are farther apart than `separation` at t=0 by more than `reach` times their relative speed are culled
  /// (solve/start_gap.hpp).
  void (*near_vf)(const PackedVertex* vertices, const PairSeparation& separation, float reach, const PairBuffer& in,
                  PairBuffer& out);
  void (*near_ee)(const PackedVertex* vertices, const PairSeparation& separation, float reach, const PairBuffer& in,
                  PairBuffer& out);
  /// Slab clip: pairs that stay farther apart than `separation` are culled. Survivors, with their times, go to `out`.
  void (*slab_vf)(const BoxVertex* vertices, const BoxSeparation& separation, const PairBuffer& in, PairBuffer& out);
  void (*slab_ee)(const BoxVertex* vertices, const BoxSeparation& separation, const PairBuffer& in, PairBuffer& out);
  /// DNF, then NCF, on what is left of the step. Returns how many pairs NCF had to look at.
  int (*filter_vf)(const PackedVertex* vertices, const PairBuffer& in, PairBuffer& out);
  int (*filter_ee)(const PackedVertex* vertices, const PairBuffer& in, PairBuffer& out);
  /// Roots and inside test. Writes the pairs that touch or are undecided, returns their number; `rest` is scratch.
  int (*solve_vf)(const PackedVertex* vertices, const PairBuffer& in, PairBuffer& rest, SolvedPair* out);
  int (*solve_ee)(const PackedVertex* vertices, const PairBuffer& in, PairBuffer& rest, SolvedPair* out);
};

/// The kernels of `isa`; throws InvalidOptions if this machine or build has none. `best`: the widest there is.
const Kernels& kernels(Isa isa);

}  // namespace tamis

// Conducts the questions about a mesh on a path: piece by piece a linear question in which every vertex has its
// deviation as radius; each pair that this leaves is decided on its curves.
#pragma once
#include <span>
#include <vector>

#include "numerics/held_bytes.hpp"
#include "paths/pairs_on_parts.hpp"
#include "query/engine.hpp"
#include "tamis/path.hpp"

namespace tamis {

/// A question about a mesh on a path.
struct MeshOnPath {
  const Path& path;
  const Separations& separations;
  double tolerance;
  bool ignores_start = false;         ///< as in Query
  std::span<const double> ends = {};  ///< of the pieces, ascending, the last one 1; empty: as deviations ask for
  /// In [0, 1): the part of its clearance at t=0 that a pair must keep. If it is not 0, a pair counts as touching where
  /// no more is left.
  double keep = 0;
};

class PathSearch {
 public:
  /// Keeps references.
  PathSearch(const Mesh& mesh, const Options& options, const Rings& rings, Engine& engine)
      : mesh_(mesh), options_(options), rings_(rings), engine_(engine), parts_(kernels(options.isa)) {}

  /// Writes every pair that touches, once, in no order; for `earliest` and `is_free` the search ends soon after the
  /// first. Throws InvalidPath: a path of another number of vertices, or one that breaks its promises. REQUIRES: a
  /// finite fixed separation >= 0, radii of all vertices or none, a tolerance > 0. REQUIRES (not checked: O(n)): finite
  /// radii >= 0. Runs in the caller's oneTBB arena.
  void find(const MeshOnPath& asked, Question question, std::vector<Contact>& contacts, Statistics& statistics);
  /// How far all vertices may go so that every pair keeps its part. Otherwise as `find`.
  SafeStep find_step_length(const MeshOnPath& asked, Statistics& statistics);
  std::uint64_t memory_bytes() const { return held_bytes(found_, parts_, radii_); }

 private:
  struct Run;  ///< one question

  const Mesh& mesh_;
  const Options& options_;
  const Rings& rings_;
  Engine& engine_;
  // Kept from question to question.
  ContactCollector found_;  ///< pairs that may touch on a piece
  PairsOnParts parts_;      ///< of these pairs
  std::vector<double> radii_;
};

/// The first of these contacts, as keep_first() has it.
EarliestContact first_of(const std::vector<Contact>& contacts);

}  // namespace tamis

// Answers questions about a mesh on a path. Each piece becomes a linear query with deviations added to the vertices'
// radii. Each pair that the linear query cannot prove free is decided on its curves.
#pragma once
#include <map>
#include <set>
#include <span>
#include <tuple>
#include <vector>

#include "curves/paths/mesh_pieces.hpp"
#include "curves/paths/pairs_on_parts.hpp"
#include "pair/motion/time_clip.hpp"
#include "search/query/engine.hpp"
#include "tamis/path.hpp"

namespace tamis {

/// A question about a mesh on a path.
struct MeshOnPath {
  const Path& path;
  const Query& query;  ///< without a step. REQUIRES: a finite fixed separation >= 0, radii of all vertices or none
  double tolerance;    ///< > 0
  std::span<const double> ends = {};  ///< of the pieces, ascending, the last 1; if empty, by deviations
  /// In [0, 1): the part of its clearance at t=0 that a pair must keep. If not 0, a pair counts as touching once no
  /// more than this part is left.
  double keep = 0;
};

/// One question, asked once. Throws InvalidPath if the path has another number of vertices or breaks its promises. Runs
/// in the caller's arena.
class PathSearch {
 public:
  /// Keeps references. REQUIRES (not checked: O(n)): finite radii >= 0.
  PathSearch(const Mesh& mesh, const MeshOnPath& asked, Engine& engine, const Kernels& kernels, Statistics& statistics);

  /// Every pair that touches, once, in no order. For `is_free` and `earliest` the search ends soon after the first.
  /// With Query::each_of these are the first contacts of the pairs of bodies.
  std::vector<Contact> find();
  /// The fraction of the path that all vertices may go while every pair keeps its part of its clearance. REQUIRES: an
  /// `earliest` query.
  SafeStep find_step_length();

 private:
  using PairKey = std::tuple<PairKind, PairVertices>;
  static PairKey key_of(const Contact& pair) { return {pair.kind, pair.vertices}; }

  /// For each vertex: the distance within which pairs are searched on a piece that ends at `to`, beyond the fixed
  /// separation.
  std::vector<double> radii_to_search(const MeshMoment& to) const;
  /// Leaves in candidates_ the pairs whose chords come within searched_ on a piece.
  void search_chords(const MeshMoment& from, const MeshMoment& to);
  void begin_bound_on_piece(const TimeInterval<double>& piece);
  /// Decides these pairs on their curves.
  void decide_all(const MeshMoment& from, const MeshMoment& to);
  /// Decides the candidates at these places, in parallel, and lowers the bound.
  void decide(const TimeInterval<double>& piece, std::span<const std::int32_t> places);
  /// True if the pair, which is apart before the time `from`, can still change the answer.
  bool wants(const Contact& pair, double from) const {
    return !bound_.is_settled() && from <= bound_.latest(query_.answer_of(pair.kind, pair.vertices));
  }
  /// True if the pair, which is ignored at the start, is still in its first contact at this time, the start of a piece.
  bool is_in_first_contact(const Contact& pair, double time) const {
    const auto found = in_contact_until_.find(key_of(pair));
    return time == 0 || (found != in_contact_until_.end() && found->second == time);
  }

  const Mesh& mesh_;
  const MeshOnPath& asked_;
  const Query& query_;  ///< the query of asked_
  Engine& engine_;
  Statistics& statistics_;
  MeshPieces pieces_;
  const MeshMoment start_;              ///< at t=0
  std::vector<double> searched_radii_;  ///< of the piece; deviations are added to these, vertex by vertex
  Separations searched_;                ///< a pair that stays farther apart need not be tested
  Bound bound_;                         ///< in times of the path
  Bound bound_on_piece_;                ///< the same in times of the piece
  ContactCollector candidates_;
  PairsOnParts parts_;  ///< of the candidates
  std::vector<Contact> contacts_;
  /// Pairs that later pieces skip: the contacts, and pairs that do not move relative to each other.
  std::set<PairKey> settled_;
  /// Ignored pairs, which touch at the start. Each has a time until which it is not known to have been apart. This is
  /// the end of a piece, or the start of the piece where it separated. Removed when the pair touches again.
  std::map<PairKey, double> in_contact_until_;
};

/// The first of these contacts in the order of keep_first().
EarliestContact first_of(const std::vector<Contact>& contacts);

}  // namespace tamis

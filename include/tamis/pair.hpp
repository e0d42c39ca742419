// Pairs of features, one or many: for callers who have a broad phase of their own.
#pragma once
#include <array>
#include <functional>
#include <span>
#include <vector>

#include "tamis/contact.hpp"
#include "tamis/options.hpp"
#include "tamis/step.hpp"

namespace tamis {

/// Whether and when one pair touches during the step. Members as in Contact; if `touches` is false, the others have no
/// meaning.
struct PairResult {
  bool touches = false;                        ///< false: proven free
  Certainty certainty = Certainty::certified;  ///< unresolved on a path alone
  double toi_lower = 1;                        ///< as in Contact
  double toi_upper = 1;                        ///< as in Contact
  double u = 0;                                ///< as in Contact
  double v = 0;                                ///< as in Contact
  Point normal{0, 0, 0};                       ///< as in Contact
};

/// Options of questions about pairs: one pair or a list, on a step or on a path.
struct PairOptions {
  double min_separation = 0;  ///< d >= 0, in the unit of the positions: contact means Euclidean distance <= d
  /// The latest time of interest, in [0,1]. A pair that is proven apart until then counts as free. The answers about
  /// other pairs do not depend on it.
  double latest = 1;
  double tolerance = PathOptions().tolerance;  ///< for a path, as in PathOptions
  int threads = 0;      ///< for a list, as in Options; 0: as many as the caller's oneTBB arena gives
  Isa isa = Isa::best;  ///< for a list; changes speed only
  /// For a list or a path, as in Options: called again and again. Once it returns true, the call throws Cancelled.
  std::function<bool()> is_cancelled = nullptr;
  ParallelFor parallel_for = nullptr;  ///< for a list, as in Options
};

/// Decides a vertex p against a face a b c, each point moving on a straight line. The arrays hold p a b c. May be
/// called from several threads.
/// Returns whether and when they touch.
/// Throws InvalidStep on NaN or infinity, InvalidOptions on an option outside its range.
[[nodiscard]] PairResult vertex_face(const std::array<Point, 4>& start, const std::array<Point, 4>& end,
                                     const PairOptions& = {});
/// Decides edge (0,1) against edge (2,3); otherwise the same.
[[nodiscard]] PairResult edge_edge(const std::array<Point, 4>& start, const std::array<Point, 4>& end,
                                   const PairOptions& = {});
/// Decides a point against a segment: p, then its ends a b; otherwise the same.
[[nodiscard]] PairResult vertex_edge(const std::array<Point, 3>& start, const std::array<Point, 3>& end,
                                     const PairOptions& = {});
/// Decides two points; otherwise the same.
[[nodiscard]] PairResult vertex_vertex(const std::array<Point, 2>& start, const std::array<Point, 2>& end,
                                       const PairOptions& = {});

/// One pair of a list, such as a broad phase returns.
struct FeaturePair {
  PairKind kind;  ///< which features
  /// Rows of the step's positions, in the order of the functions above: p a b c, a0 a1 b0 b1, p a b, or p q. Entries
  /// that a kind does not use are not read.
  std::array<Index, 4> vertices;
};

/// Decides a list of pairs: the narrow phase. Writes the answer about pairs[i] to `results[i]`. The answer has the bits
/// of the function for one pair. It takes a small part of the time. The positions may have any number of rows, the same
/// at both ends. Only rows that pairs name are read.
/// Throws InvalidStep, naming the first such pair, if a kind does not exist, an index is not a row, or a coordinate is
/// not finite. Throws it also unless there are as many results as pairs. Throws InvalidOptions on an option outside its
/// range.
void narrow_phase(std::span<const FeaturePair> pairs, const Step& step, std::span<PairResult> results,
                  const PairOptions& = {});
/// Decides a list of pairs.
/// Returns an answer for each pair.
/// Throws as above.
[[nodiscard]] std::vector<PairResult> narrow_phase(std::span<const FeaturePair> pairs, const Step& step,
                                                   const PairOptions& = {});
/// Decides pairs of one kind that are given as points. A pair has four, three or two points, and one pair follows the
/// other.
/// Throws InvalidStep unless both ends have as many points as `results` needs.
void narrow_phase(PairKind kind, std::span<const Point> start, std::span<const Point> end,
                  std::span<PairResult> results, const PairOptions& = {});

}  // namespace tamis

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

/// What one pair does during the step: as in Contact. What follows `touches` has no meaning if the pair is free.
struct PairResult {
  bool touches = false;                        ///< false: proven free
  Certainty certainty = Certainty::certified;  ///< unresolved on a path alone
  double toi_lower = 1;
  double toi_upper = 1;
  double u = 0;
  double v = 0;
  Point normal{0, 0, 0};
};

/// How questions about pairs are answered: one or a list, on a step or on a path.
struct PairOptions {
  double min_separation = 0;  ///< d >= 0, in the unit of the positions: contact means Euclidean distance <= d
  /// The latest time of interest, in [0,1]: a pair that is proven apart until then is free. Other answers do
  /// not depend on it.
  double latest = 1;
  double tolerance = 1e-9;  ///< of a path: the widest bracket of a contact, a fraction of the step in (0, 1]
  int threads = 0;          ///< of a list, as in Options: 0 is as many as the caller's oneTBB arena gives
  Isa isa = Isa::best;      ///< of a list; speed only
  /// Of a list or a path, as in Options: once it says true, asked again and again, the call throws Cancelled.
  std::function<bool()> is_cancelled = nullptr;
};

/// A vertex against a face: p, then its corners a b c, each moving on a straight line. May be called from several
/// threads. Throws InvalidStep on NaN or infinity, InvalidOptions on an option outside its range.
PairResult vertex_face(const std::array<Point, 4>& start, const std::array<Point, 4>& end, const PairOptions& = {});
/// Edge (0,1) against edge (2,3); otherwise the same.
PairResult edge_edge(const std::array<Point, 4>& start, const std::array<Point, 4>& end, const PairOptions& = {});
/// A point against a segment: p, then its ends a b; otherwise the same.
PairResult vertex_edge(const std::array<Point, 3>& start, const std::array<Point, 3>& end, const PairOptions& = {});
/// Two points; otherwise the same.
PairResult vertex_vertex(const std::array<Point, 2>& start, const std::array<Point, 2>& end, const PairOptions& = {});

/// One pair of a list: what a broad phase hands on.
struct Pair {
  PairKind kind;
  /// Rows of the step's positions, in the order of the functions above: p a b c, a0 a1 b0 b1, p a b, or p q. What a
  /// kind does not use is not read.
  std::array<Index, 4> vertices;
};

/// The narrow phase of a list: `results[i]` is what pairs[i] does during the step, bit for bit what the function for
/// one pair says of it, many times faster. The positions have any number of rows, the same at both ends; only those
/// that pairs name are read. Throws InvalidStep, naming the first such pair: a kind that is none, an index that is no
/// row, a coordinate that is not finite; also unless there are as many results as pairs. InvalidOptions.
void narrow_phase(std::span<const Pair> pairs, const Step& step, std::span<PairResult> results,
                  const PairOptions& = {});
std::vector<PairResult> narrow_phase(std::span<const Pair> pairs, const Step& step, const PairOptions& = {});
/// The same of pairs of one kind that come as points: four, three or two a pair, one pair behind the other. Throws
/// InvalidStep unless there are as many at both ends as `results` need.
void narrow_phase(PairKind kind, std::span<const Point> start, std::span<const Point> end,
                  std::span<PairResult> results, const PairOptions& = {});

}  // namespace tamis

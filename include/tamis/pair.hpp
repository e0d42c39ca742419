// One pair of features: for callers who have a broad phase of their own.
#pragma once
#include <array>

#include "tamis/contact.hpp"
#include "tamis/options.hpp"

namespace tamis {

/// What one pair does during the step: as in Contact. What follows `touches` has no meaning if the pair is free.
struct PairResult {
  bool touches = false;  ///< false: proven free
  Certainty certainty = Certainty::certified;
  double toi_lower = 1;
  double toi_upper = 1;
  double u = 0;
  double v = 0;
  Point normal{0, 0, 0};
};

struct PairOptions {
  Guarantee guarantee = Guarantee::exact;
  double min_separation = 0;  ///< d >= 0, in the unit of the positions: contact means Euclidean distance <= d
};

/// A vertex against a face: p, then its corners a b c, each moving on a straight line. May be called from several
/// threads. Throws InvalidStep on NaN or infinity, InvalidOptions unless the separation is finite and >= 0.
PairResult vertex_face(const std::array<Point, 4>& start, const std::array<Point, 4>& end, const PairOptions& = {});
/// Edge (0,1) against edge (2,3); otherwise the same.
PairResult edge_edge(const std::array<Point, 4>& start, const std::array<Point, 4>& end, const PairOptions& = {});
/// A point against a segment: p, then its ends a b; otherwise the same.
PairResult vertex_edge(const std::array<Point, 3>& start, const std::array<Point, 3>& end, const PairOptions& = {});
/// Two points; otherwise the same.
PairResult vertex_vertex(const std::array<Point, 2>& start, const std::array<Point, 2>& end, const PairOptions& = {});

}  // namespace tamis

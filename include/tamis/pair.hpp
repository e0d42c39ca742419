// One pair of features: for callers who have a broad phase of their own.
#pragma once
#include <array>

#include "tamis/contact.hpp"
#include "tamis/options.hpp"

namespace tamis {

/// What one pair does during the step.
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
  Guarantee guarantee = Guarantee::conservative;
  double min_separation = 0;  ///< finite, >= 0; see Options
};

/// A vertex against a face (its three corners), each moving on a straight line. Throws InvalidStep on NaN or infinity,
/// InvalidOptions on a separation out of range.
PairResult vertex_face(const std::array<Point, 4>& start, const std::array<Point, 4>& end, const PairOptions& = {});
/// Edge (0,1) against edge (2,3).
PairResult edge_edge(const std::array<Point, 4>& start, const std::array<Point, 4>& end, const PairOptions& = {});

}  // namespace tamis

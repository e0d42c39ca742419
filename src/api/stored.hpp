// Rounding to the numbers in which a caller stores positions.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "search/topology/at.hpp"
#include "tamis/positions.hpp"
#include "tamis/stored.hpp"

namespace tamis {

/// x, rounded to the nearest number that is stored.
inline double rounded(double x, Stored stored) {
  return stored == Stored::float32 ? static_cast<double>(static_cast<float>(x)) : x;
}

inline std::vector<Point> rounded(const Positions& positions, Stored stored) {
  std::vector<Point> points(at(positions.count()));
  for (Index v = 0; v < positions.count(); ++v)
    for (std::size_t k = 0; k < 3; ++k) points[at(v)][k] = rounded(positions[v][k], stored);
  return points;
}

/// An upper bound of the rounding of a coordinate between `start` and `end`: half a unit in the last place. 0 for
/// doubles: the margin of KeptFractions::between_planes covers their rounding.
inline double max_rounding(double start, double end, Stored stored) {
  if (stored == Stored::float64) return 0;
  return 0x1p-24 * std::max(std::fabs(start), std::fabs(end)) + 0x1p-150;
}

}  // namespace tamis

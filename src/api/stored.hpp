// Rounding to the numbers in which a caller stores positions.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "search/topology/at.hpp"
#include "tamis/positions.hpp"
#include "tamis/stored_type.hpp"

namespace tamis {

/// x, rounded to the nearest number that is stored.
inline double rounded(double x, StoredType stored) {
  return stored == StoredType::float32 ? static_cast<double>(static_cast<float>(x)) : x;
}

inline std::vector<Point> rounded(const Positions& positions, StoredType stored) {
  std::vector<Point> points(at(positions.count()));
  for (Index v = 0; v < positions.count(); ++v)
    for (std::size_t k = 0; k < 3; ++k) points[at(v)][k] = rounded(positions[v][k], stored);
  return points;
}

/// An upper bound of the rounding of a coordinate between `start` and `end`: half a unit in the last place. Zero for
/// doubles: the margin of KeptFractions::between_planes covers their rounding.
inline double max_rounding(double start, double end, StoredType stored) {
  if (stored == StoredType::float64) return 0;
  return 0x1p-24 * std::max(std::fabs(start), std::fabs(end)) + 0x1p-150;
}

}  // namespace tamis

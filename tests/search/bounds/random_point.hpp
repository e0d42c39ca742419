#pragma once
#include <random>

#include "numbers/vec.hpp"

namespace tamis {

/// In a box of this half-width about the origin.
inline Vec3<double> random_point(std::mt19937_64& random, double half_width) {
  std::uniform_real_distribution<double> coordinate(-half_width, half_width);
  return {coordinate(random), coordinate(random), coordinate(random)};
}

}  // namespace tamis

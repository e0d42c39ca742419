// The vertices of a mesh at the ends of a piece of its path, and how near the chords between must come for the curves
// to touch.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "motion/separations.hpp"
#include "motion/time_clip.hpp"
#include "numerics/axes.hpp"
#include "numerics/error_bounds.hpp"
#include "numerics/number_text.hpp"
#include "tamis/error.hpp"
#include "tamis/path.hpp"

namespace tamis {

/// Positions and their errors at one time, by vertex. Those of vertices that were not asked for mean nothing.
struct Frame {
  double time = 0;
  std::vector<Point> points;
  std::vector<double> errors;
};

/// The radius of `vertex` on its chord, so that the chord stands for the curve: its deviation, the error of its
/// positions at both ends (`error`, on each axis), and the largest radius of its features (largest_beside). Throws
/// InvalidPath, naming where the piece begins, unless that is finite.
inline double radius_on_piece(Index vertex, double deviation, double error, double start,
                              const Separations& separations) {
  double radius = (deviation + kRootOfThree * kRoundedUp * error) * (1 + 0x1p-50) + 0x1p-1000;
  if (!separations.radii.empty())
    radius = (radius + separations.radii[static_cast<std::size_t>(vertex)]) * (1 + 0x1p-50);
  if (!std::isfinite(radius))
    throw InvalidPath("vertex " + std::to_string(vertex) + " of the path deviates without bound after t = " +
                      number_text(start) + ": give a finite bound for short pieces");
  return radius;
}

inline double near_middle(double from, double to) { return from + kNearMiddle * (to - from); }

}  // namespace tamis

// The vertices of a mesh at one time of its path, and the radii around chords between two such times that hold the
// curves.
#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "numbers/axes.hpp"
#include "numbers/error_bounds.hpp"
#include "numbers/number_text.hpp"
#include "pair/motion/separations.hpp"
#include "tamis/error.hpp"
#include "tamis/path.hpp"

namespace tamis {

/// Positions and their errors at one time, by vertex. Entries of vertices that were not requested mean nothing.
struct MeshMoment {
  double time = 0;
  std::vector<Point> points;
  std::vector<double> errors;
};

/// The radius of a vertex on its chord is the sum of its deviation, the error of its positions at both ends (`error`,
/// on each axis), and its radius in `separations` (PathSearch::radii_to_search). Throws InvalidPath, naming the start
/// of the piece, unless the sum is finite.
inline double chord_radius(Index vertex, double deviation, double error, double start, const Separations& separations) {
  double radius = (deviation + kRootOfThree * kRoundedUp * error) * (1 + 0x1p-50) + 0x1p-1000;
  if (!separations.radii.empty())
    radius = (radius + separations.radii[static_cast<std::size_t>(vertex)]) * (1 + 0x1p-50);
  if (!std::isfinite(radius))
    throw InvalidPath("vertex " + std::to_string(vertex) + " of the path " +
                      (std::isfinite(deviation) ? "is off" : "deviates") +
                      " without bound after t = " + number_text(start) + ": give a finite bound for short pieces");
  return radius;
}

}  // namespace tamis

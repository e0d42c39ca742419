#include "audit/doubts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

namespace tamis::audit {
namespace {

/// The longest side of the box around the finite points.
double size_of(const Positions& positions) {
  double size = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double lowest = std::numeric_limits<double>::max(), highest = -lowest;
    for (Index v = 0; v < positions.count(); ++v) {
      const double x = positions[v][axis];
      if (!std::isfinite(x)) continue;
      lowest = std::min(lowest, x);
      highest = std::max(highest, x);
    }
    size = std::max(size, highest - lowest);
  }
  return size;
}

}  // namespace

std::size_t coincident_vertices(const Mesh& mesh, const Positions& positions) {
  std::vector<std::array<double, 3>> places;
  for (const Index v : mesh.points()) places.push_back({positions[v][0], positions[v][1], positions[v][2]});
  std::sort(places.begin(), places.end());
  return static_cast<std::size_t>(places.end() - std::unique(places.begin(), places.end()));
}

std::string doubt_about_coincidence(const Mesh& mesh, const Positions& positions) {
  const std::size_t count = coincident_vertices(mesh, positions);
  if (count == 0) return {};
  return std::to_string(count) + " of " + std::to_string(mesh.points().size()) + " vertices " +
         (count == 1 ? "lies" : "lie") +
         " exactly on another one, so their features touch there: if they are one vertex, join them "
         "(--weld, or tamis.weld in Python)";
}

std::string doubt_about_units(const Positions& start, const Positions& end) {
  // An inch is a 39th of a metre; what moves seldom grows that much in a step.
  constexpr double kMost = 35;
  const double first = size_of(start), second = size_of(end);
  const double ratio = std::max(first, second) / std::min(first, second);
  if (!(ratio > kMost) || !std::isfinite(ratio)) return {};
  std::array<char, 32> factor{};
  std::snprintf(factor.data(), factor.size(), "%.3g", ratio);
  return std::string("the mesh is ") + factor.data() + " times as " + (second > first ? "large" : "small") +
         " as at the start of the step: give both in the same unit";
}

}  // namespace tamis::audit

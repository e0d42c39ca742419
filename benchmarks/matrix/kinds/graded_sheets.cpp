#include <algorithm>
#include <cmath>

#include "matrix/kinds/kinds.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace tamis::matrix {
namespace {

constexpr double kGrading = 1000;  // widest cell to narrowest
constexpr double kRipple = 0.01;   // in half widths of a sheet
constexpr double kFall = 0.03;

/// Lines from -1 to 1, closest in the middle. Uses integer powers only, so that every machine makes the same bits.
std::vector<double> graded_lines(Index count) {
  std::vector<double> lines;
  for (Index i = 0; i < count; ++i) {
    const double t = count > 1 ? 2.0 * i / (count - 1) - 1 : 0;
    lines.push_back(t * (1 / kGrading + t * t * t * t));
  }
  return lines;
}

}  // namespace

scenes::Scene graded_sheets(Index triangles, std::uint64_t seed) {
  const Index side = std::max(Index{2}, static_cast<Index>(std::sqrt(triangles / 4.0)) + 1);
  const std::vector<double> lines = graded_lines(side);
  scenes::Scene scene;
  for (Index sheet = 0; sheet < 2; ++sheet) {
    const scenes::SmoothNoise ripple(seed * 2 + static_cast<std::uint64_t>(sheet));
    const Index first = scene.vertex_count();
    for (const double x : lines)
      for (const double z : lines) {
        const double y = kRipple * (2.5 * sheet + ripple(20 * x, 20 * z));
        scene.add_vertex({x, y, z}, {x + kFall / 2 * sheet, y - kFall * sheet, z}, sheet);
      }
    scenes::add_grid_faces(scene, first, side, side);
  }
  return scene;
}

}  // namespace tamis::matrix

// One sheet folded to and fro into close layers. The layers are free at t=0; during the step the pile is
// pressed together and each layer ripples and creeps, so that a small share of the area runs into its neighbours.
#include <algorithm>
#include <cmath>

#include "scenes/generators/generators.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace tamis::scenes {
namespace {

// Lengths in cells of the grid.
constexpr double kLayerGap = 0.4;
constexpr double kRippleStart = 0.15;  // below half the gap: no contact at t=0
constexpr double kRippleEnd = 0.35;
constexpr double kPilePress = 0.1;  // share of its height that the pile loses
constexpr double kCreep = 0.5;
constexpr double kLongestRipple = 8;
constexpr Index kLongestLayer = 96;

}  // namespace

Scene folded_cloth(Index triangles, std::uint64_t seed) {
  const Index columns = std::max(Index{2}, static_cast<Index>(std::sqrt(triangles / 2.0)) + 1);
  const Index rows = std::max(Index{4}, triangles / (2 * (columns - 1)) + 1);
  const Index layer_rows = std::clamp(rows / 6, Index{2}, kLongestLayer);
  const double cell = 1.0 / columns, ripple = std::clamp(columns / 6.0, 2.0, kLongestRipple);

  Scene scene;
  for (Index i = 0; i < rows; ++i) {
    const Index layer = i / layer_rows, offset = i % layer_rows;
    const double x = layer % 2 == 0 ? offset : layer_rows - 1 - offset;
    const auto noise = [&](std::uint64_t which) {
      return SmoothNoise(seed * 1000003 + static_cast<std::uint64_t>(layer) * 8 + which);
    };
    const SmoothNoise start = noise(0), end = noise(1), creep_x = noise(2), creep_z = noise(3);
    for (Index j = 0; j < columns; ++j) {
      const double z = j, px = x / ripple, pz = z / ripple;
      const double height = layer * kLayerGap;
      const Point at_start{x, height + kRippleStart * start(px, pz), z};
      const Point at_end{x + kCreep * creep_x(px, pz), (1 - kPilePress) * height + kRippleEnd * end(px, pz),
                         z + kCreep * creep_z(px, pz)};
      scene.add_vertex({cell * at_start[0], cell * at_start[1], cell * at_start[2]},
                       {cell * at_end[0], cell * at_end[1], cell * at_end[2]}, 0);
    }
  }
  add_grid_faces(scene, 0, rows, columns);
  return scene;
}

}  // namespace tamis::scenes

// Two level sheets above each other, the second one shifted a little, so that no vertex or edge meets its counterpart.
#pragma once
#include "scenes/scene.hpp"
#include "scenes/shapes.hpp"

namespace tamis::test {

/// Each sheet has side x side vertices at distance 1, and its own group. The first stays at height 0, the second moves
/// from height `from` to `to`.
inline scenes::Scene flat_sheets(Index side, double from, double to) {
  scenes::Scene scene;
  for (Index sheet = 0; sheet < 2; ++sheet) {
    const Index first = scene.vertex_count();
    for (Index i = 0; i < side; ++i)
      for (Index j = 0; j < side; ++j) {
        const double x = i + 0.3 * sheet, z = j + 0.2 * sheet;
        scene.add_vertex({x, from * sheet, z}, {x, to * sheet, z}, sheet);
      }
    scenes::add_grid_faces(scene, first, side, side);
  }
  return scene;
}

}  // namespace tamis::test

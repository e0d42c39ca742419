// Shapes that several tests of worlds share.
#pragma once
#include <vector>

#include "scenes/shapes.hpp"
#include "tamis/world.hpp"

namespace tamis::test {

/// With corners (+-1, +-1, +-1).
inline Shape cube() {
  const scenes::Shape cube = scenes::unit_cube(2);
  return {Mesh(static_cast<Index>(cube.points.size()), cube.faces), cube.points};
}

/// Of side 20, at z = 0.
inline Shape floor() {
  const std::vector<Point> points{{-10, -10, 0}, {10, -10, 0}, {10, 10, 0}, {-10, 10, 0}};
  return {Mesh(4, {{0, 1, 2}, {0, 2, 3}}), points};
}

}  // namespace tamis::test

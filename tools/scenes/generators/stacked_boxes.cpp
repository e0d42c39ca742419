// Boxes in brickwork, each layer exactly on the one below it and half a box aside: faces share planes. In the step the
// boxes rest, slide along their planes, lift off, or press down.
#include <algorithm>
#include <cmath>

#include "scenes/generators/generators.hpp"
#include "scenes/point_math.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace tamis::scenes {
namespace {

constexpr Index kFewestBoxes = 8;
constexpr Index kMostBoxCells = 16;
constexpr double kBoxUnit = 0x1p-10;
constexpr double kPitch = 2.25;  // from box to box in a layer; a side is 2

/// Neighbours rest, slide, lift off and press down in turn.
Point box_motion(Index box, Random& random) {
  switch (box % 4) {
    case 0:
      return {0, 0, 0};
    case 1:
      return {random.on_lattice(64, kBoxUnit), random.on_lattice(64, kBoxUnit), 0};
    case 2:
      return {0, 0, random.below(64) * kBoxUnit};
    default:
      return {0, 0, -(1 + random.below(63)) * kBoxUnit};
  }
}

}  // namespace

Scene stacked_boxes(Index triangles, std::uint64_t seed) {
  const Index cells = sphere_cells(triangles, kFewestBoxes, kMostBoxCells);
  const Shape box = unit_cube(cells);
  const Index boxes = std::max(Index{2}, triangles / static_cast<Index>(box.faces.size()));
  const Index side = static_cast<Index>(cube_root(boxes));  // several layers, however few boxes
  Scene scene;
  Random random(seed);
  for (Index b = 0; b < boxes; ++b) {
    const Index layer = b / (side * side);
    const double aside = layer % 2 == 0 ? 0 : kPitch / 2;
    const Point centre{kPitch * (b % side) + aside, kPitch * (b / side % side) + aside, 2.0 * layer};
    const Point flight = box_motion(b, random);
    add_shape(
        scene, box, b, [&](const Point& p) { return centre + p; }, [&](const Point& p) { return centre + flight + p; });
  }
  return scene;
}

}  // namespace tamis::scenes

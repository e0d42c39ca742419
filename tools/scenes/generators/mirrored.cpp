// Pairs of triangles whose starts and motions are mirror images in the plane x = 0, on a lattice of powers of two. The
// two can only touch on the mirror: every contact is exact, and plain floating point loses some of these contacts.
#include "scenes/generators/generators.hpp"
#include "scenes/point_math.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace tamis::scenes {
namespace {

constexpr double kMirrorUnit = 0x1p-6;

std::array<Point, 3> mirror_image(std::array<Point, 3> corners) {
  for (Point& p : corners) p[0] = -p[0];
  return corners;
}

}  // namespace

Scene mirrored(Index triangles, std::uint64_t seed) {
  Scene scene;
  Random random(seed);
  for (Index i = 0; i < (triangles + 1) / 2; ++i) {
    // Starts to the right of the mirror, and each corner ends on it, before it, or (most of them) beyond it.
    const Point centre{40 * kMirrorUnit, random.on_lattice(64, kMirrorUnit), random.on_lattice(64, kMirrorUnit)};
    std::array<Point, 3> start, end;
    for (std::size_t k = 0; k < 3; ++k) {
      start[k] = centre + random.point_on_lattice(24, kMirrorUnit);
      end[k] = start[k] + random.point_on_lattice(8, kMirrorUnit);
      end[k][0] = random.below(4) == 0 ? 0 : random.on_lattice(16, kMirrorUnit) - 8 * kMirrorUnit;
    }
    add_triangle(scene, start, end, 2 * i);
    add_triangle(scene, mirror_image(start), mirror_image(end), 2 * i + 1);
  }
  return scene;
}

}  // namespace tamis::scenes

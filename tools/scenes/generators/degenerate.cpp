// Degenerate triangles: the degeneracies take turns. Corners lie on a coarse lattice of powers of two, so
// that exact coincidences (equal points, collinear edges, coplanar faces) are common.
#include <cmath>

#include "scenes/generators/generators.hpp"
#include "scenes/point_math.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace tamis::scenes {
namespace {

using Corners = std::array<Point, 3>;

constexpr double kLatticeUnit = 0.25;

Corners lattice_corners(const Point& centre, Random& random) {
  Corners corners;
  for (Point& p : corners) p = centre + random.point_on_lattice(4, kLatticeUnit);
  return corners;
}

void make_collinear(Corners& corners) { corners[2] = 2.0 * corners[1] - corners[0]; }

}  // namespace

Scene degenerate(Index triangles, std::uint64_t seed) {
  Scene scene;
  Random random(seed);
  // A larger box for more triangles keeps the number of contacts of each in bounds.
  const Index side = static_cast<Index>(2 * cube_root(static_cast<double>(triangles)));
  for (Index i = 0; static_cast<Index>(scene.faces.size()) < triangles; ++i) {
    const Point centre = random.point_on_lattice(side, kLatticeUnit);
    Corners start = lattice_corners(centre, random), end = lattice_corners(centre, random);
    const Index which = i % 10;
    if (which == 0 || which == 2) make_collinear(start);   // no area at t=0
    if (which == 1 || which == 2) make_collinear(end);     // no area at t=1; with the line above, at both
    if (which == 3) start[1] = start[0], end[1] = end[0];  // an edge without length, always
    if (which == 4) end[1] = end[0];                       // an edge that loses its length
    if (which == 5) start[2] = start[1] = start[0], end[2] = end[1] = end[0];  // one point
    if (which == 6) end = start;                                               // does not move
    add_triangle(scene, start, end, i);
    const Face face = scene.faces.back();
    if (which == 7) scene.faces.back() = {face[0], face[1], face[1]};
    if (which == 8) scene.faces.back() = {face[0], face[0], face[0]};
    if (which == 9) scene.faces.push_back({face[2], face[1], face[0]});  // the same, turned over
  }
  return scene;
}

}  // namespace tamis::scenes

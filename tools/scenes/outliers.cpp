#include "scenes/outliers.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "scenes/point_math.hpp"
#include "scenes/shapes.hpp"

namespace tamis::scenes {
namespace {

constexpr Point kRise{0, 0.06, 0};

void add_triangle(Scene& scene, const std::array<Point, 3>& corners, const Point& way) {
  const Index first = scene.vertex_count();
  for (const Point& corner : corners) scene.add_vertex(corner, corner + way, 0);
  scene.faces.push_back({first, first + 1, first + 2});
}

/// Coordinates are multiples of 2^-20: floats cannot hold them at this distance; doubles hold even their halves.
void add_fallen_triangles(Scene& scene, double d) {
  const auto in_plane = [&](double x, double z) { return 0x1p-20 * Point{x, -x, z} + Point{0, -d, 0}; };
  const Point a = in_plane(12345, 77777), b = in_plane(98765, 33333), c = in_plane(54321, 123457);
  add_triangle(scene, {a, b, c}, {});
  const Point way{-0.125, -0.125, 0}, corner = in_plane(0.5 * (12345 + 98765), 0.5 * (77777 + 33333)) + -1.0 * way;
  add_triangle(scene, {corner, corner + Point{0.1, 0.2, 0}, corner + Point{0.2, 0.1, 0.1}}, way);
}

/// A grid of `edges` edges a side: a plain under the scene, and slopes around it.
void add_terrain(Scene& scene, Index edges, double d) {
  const Index first = scene.vertex_count();
  for (Index row = 0; row <= edges; ++row)
    for (Index column = 0; column <= edges; ++column) {
      const double x = 2.0 * row / edges - 0.95, z = 2.0 * column / edges - 0.95;
      const Point place{d * x, -0.05 - 0.1 * d * std::max(0.0, x * x + z * z - 0.25), d * z};
      scene.add_vertex(place, place + kRise, 0);
    }
  add_grid_faces(scene, first, edges + 1, edges + 1);
}

}  // namespace

void add_outliers(Scene& scene, Outliers which, double distance) {
  const double d = distance;
  const std::size_t middle = scene.start.size() / 2;
  switch (which) {
    case Outliers::fallen_triangles:
      return add_fallen_triangles(scene, d);
    case Outliers::flying_triangle:
      return add_triangle(scene, {{{d, 2, 0}, {d, 2.1, 0}, {d, 2, 0.1}}}, {-2 * d, 0, 0});
    case Outliers::wide_ground:
      return add_triangle(scene, {{{-d, -0.05, -d}, {2 * d, -0.05, -d}, {0, -0.05, d}}}, kRise);
    case Outliers::wide_terrain:
      return add_terrain(scene, static_cast<Index>(std::sqrt(2.0 * scene.vertex_count())), d);
    case Outliers::lost_vertex:
      scene.start[middle][1] += d;
      [[fallthrough]];
    case Outliers::flying_vertex:
      scene.end[middle][1] += d;
      return;
  }
}

}  // namespace tamis::scenes

// Building blocks of scenes: grids, spheres, single triangles.
#pragma once
#include <vector>

#include "scenes/scene.hpp"

namespace tamis::scenes {

/// The two triangles of each cell of a grid of `rows` x `columns` vertices, numbered row by row from `first_vertex`.
void add_grid_faces(Scene& scene, Index first_vertex, Index rows, Index columns);

/// Three new vertices and their triangle.
void add_triangle(Scene& scene, const std::array<Point, 3>& start, const std::array<Point, 3>& end, Index group);

struct Shape {
  std::vector<Point> points;
  std::vector<Face> faces;
};

/// The cube with corners (+-1, +-1, +-1), of 6 x cells x cells quads: 12 cells^2 triangles, closed, symmetric in x, y,
/// z.
Shape unit_cube(Index cells);

/// The same cube, blown up to the unit sphere.
Shape unit_sphere(Index cells);

/// A screw thread about the z axis, open at both ends, from z = 0 up: its rows follow the helix, so that crests are
/// edges. A nut has the same thread in a larger radius. 2 x turns x around x along triangles.
struct Thread {
  Index turns, around, along;  ///< cells of a turn, and across the thread
  double radius, pitch, depth;
};
Shape thread(const Thread& of);

/// The number of cells, in [1, most], with which about `count` spheres or cubes have `triangles` triangles in all.
Index sphere_cells(Index triangles, Index count, Index most);

/// Adds `shape` with its points moved by the two maps Point -> Point.
template <class AtStart, class AtEnd>
void add_shape(Scene& scene, const Shape& shape, Index group, AtStart at_start, AtEnd at_end) {
  const Index first = scene.vertex_count();
  for (const Point& p : shape.points) scene.add_vertex(at_start(p), at_end(p), group);
  for (const Face& f : shape.faces) scene.faces.push_back({first + f[0], first + f[1], first + f[2]});
}

}  // namespace tamis::scenes

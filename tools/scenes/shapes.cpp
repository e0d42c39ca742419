#include "scenes/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "scenes/point_math.hpp"

namespace tamis::scenes {

void add_grid_faces(Scene& scene, Index first_vertex, Index rows, Index columns) {
  for (Index i = 0; i + 1 < rows; ++i)
    for (Index j = 0; j + 1 < columns; ++j) {
      const Index a = first_vertex + i * columns + j, b = a + 1, c = a + columns, d = c + 1;
      scene.faces.push_back({a, b, d});
      scene.faces.push_back({a, d, c});
    }
}

void add_triangle(Scene& scene, const std::array<Point, 3>& start, const std::array<Point, 3>& end, Index group) {
  const Index first = scene.vertex_count();
  for (std::size_t k = 0; k < 3; ++k) scene.add_vertex(start[k], end[k], group);
  scene.faces.push_back({first, first + 1, first + 2});
}

namespace {

/// Points of the cube's surface by their lattice coordinates in [0, cells], each once.
class CubeSurface {
 public:
  CubeSurface(Shape& shape, Index cells) : shape_(shape), cells_(cells) {}

  Index vertex(const std::array<Index, 3>& lattice) {
    const auto [entry, is_new] = index_.try_emplace(lattice, static_cast<Index>(shape_.points.size()));
    if (is_new) shape_.points.push_back({centred(lattice[0]), centred(lattice[1]), centred(lattice[2])});
    return entry->second;
  }

 private:
  double centred(Index i) const { return 2 * i - cells_; }

  Shape& shape_;
  Index cells_;
  std::map<std::array<Index, 3>, Index> index_;
};

/// The cube's surface, with corners at +-cells.
Shape lattice_cube(Index cells) {
  Shape shape;
  CubeSurface surface(shape, cells);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const Index side : {0, cells})
      for (Index i = 0; i < cells; ++i)
        for (Index j = 0; j < cells; ++j) {
          const auto corner = [&](Index di, Index dj) {
            std::array<Index, 3> lattice{};
            lattice[axis] = side;
            lattice[(axis + 1) % 3] = i + di;
            lattice[(axis + 2) % 3] = j + dj;
            return surface.vertex(lattice);
          };
          const Index a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
          const bool outward = side != 0;
          shape.faces.push_back(outward ? Face{a, b, c} : Face{a, c, b});
          shape.faces.push_back(outward ? Face{a, c, d} : Face{a, d, c});
        }
  return shape;
}

}  // namespace

Shape unit_cube(Index cells) {
  Shape shape = lattice_cube(cells);
  for (Point& p : shape.points)
    for (double& x : p) x /= cells;
  return shape;
}

Shape unit_sphere(Index cells) {
  Shape shape = lattice_cube(cells);
  for (Point& p : shape.points) p = unit(p);
  return shape;
}

Shape thread(const Thread& of) {
  Shape shape;
  const Index last = (of.turns + 1) * of.around;  // where the last turn ends, one thread higher up
  for (Index row = 0; row <= last; ++row)
    for (Index cell = 0; cell < of.along; ++cell) {
      const double across = double(cell) / of.along, turn = double(row) / of.around;
      const double angle = 2 * std::numbers::pi * (row % of.around) / of.around;
      const double radius = of.radius + of.depth * (1 - std::fabs(2 * across - 1));
      shape.points.push_back({radius * std::cos(angle), radius * std::sin(angle), of.pitch * (turn + across)});
    }
  // The last cell across ends where the first one begins a turn later.
  const auto vertex = [&](Index row, Index cell) {
    return cell < of.along ? row * of.along + cell : (row + of.around) * of.along;
  };
  for (Index row = 0; row < of.turns * of.around; ++row)
    for (Index cell = 0; cell < of.along; ++cell) {
      const Index a = vertex(row, cell), b = vertex(row + 1, cell), c = vertex(row + 1, cell + 1),
                  d = vertex(row, cell + 1);
      shape.faces.insert(shape.faces.end(), {{a, b, c}, {a, c, d}});
    }
  return shape;
}

Index sphere_cells(Index triangles, Index count, Index most) {
  const double each = static_cast<double>(triangles) / (12.0 * count);
  return std::clamp(static_cast<Index>(std::lround(std::sqrt(each))), Index{1}, most);
}

}  // namespace tamis::scenes

// Building blocks of the kinds: waves and circles without the libraries' sines, surfaces over a grid, tubes.
#pragma once
#include <algorithm>
#include <cmath>

#include "scenes/point_math.hpp"
#include "scenes/scene.hpp"

namespace tamis::matrix {

/// Approximates the sine of 2 pi `turns` by two parabolas a turn.
inline double wave(double turns) {
  const double part = turns - std::floor(turns);
  return part < 0.5 ? 16 * part * (0.5 - part) : -16 * (part - 0.5) * (1 - part);
}

/// A point on the unit circle of x and y; its speed in `turns` is nearly constant.
inline Point on_circle(double turns) { return scenes::unit({wave(turns + 0.25), wave(turns), 0}); }

/// 0 before `low`, 1 after `high`, smooth between.
inline double ramp(double x, double low, double high) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// The numbers of a surface's vertices.
struct Grid {
  Index rows, columns;
  bool closes_rows = false, closes_columns = false;  ///< the first row, or column, follows the last
};

/// Adds a surface with vertices at_start(u, v) and at_end(u, v), u and v in [0,1]: u across the rows, v along a row.
template <class AtStart, class AtEnd>
void add_surface(scenes::Scene& scene, const Grid& grid, Index group, const AtStart& at_start, const AtEnd& at_end) {
  const Index first = scene.vertex_count(), rows = grid.rows - !grid.closes_rows,
              columns = grid.columns - !grid.closes_columns;  // of cells
  for (Index i = 0; i < grid.rows; ++i)
    for (Index j = 0; j < grid.columns; ++j) {
      const double u = double(i) / rows, v = double(j) / columns;
      scene.add_vertex(at_start(u, v), at_end(u, v), group);
    }
  const auto vertex = [&](Index i, Index j) { return first + i % grid.rows * grid.columns + j % grid.columns; };
  for (Index i = 0; i < rows; ++i)
    for (Index j = 0; j < columns; ++j) {
      const Index a = vertex(i, j), b = vertex(i, j + 1), c = vertex(i + 1, j), d = vertex(i + 1, j + 1);
      scene.faces.push_back({a, b, d});
      scene.faces.push_back({a, d, c});
    }
}

/// The point at `turns` around a tube about curve(u). REQUIRES: the curve never goes along the third axis, or nearly.
template <class Curve>
Point on_tube(const Curve& curve, double radius, double u, double turns) {
  using namespace scenes;
  constexpr double kNear = 1e-4;
  const Point along = unit(curve(u + kNear) - curve(u - kNear));
  const Point side = unit(cross(along, {0.13, 0.29, 1})), rim = on_circle(turns);
  return curve(u) + radius * (rim[0] * side + rim[1] * cross(along, side));
}

template <class AtStart, class AtEnd>
void add_tube(scenes::Scene& scene, const Grid& grid, double radius, Index group, const AtStart& at_start,
              const AtEnd& at_end) {
  add_surface(
      scene, grid, group, [&](double u, double v) { return on_tube(at_start, radius, u, v); },
      [&](double u, double v) { return on_tube(at_end, radius, u, v); });
}

/// The number of rows of `columns` cells that make so many triangles, and the side of such a square in vertices.
inline Index rows_for(Index triangles, Index columns) { return std::max(Index{3}, triangles / (2 * columns)); }
inline Index side_for(Index triangles) {
  return std::max(Index{3}, static_cast<Index>(std::lround(std::sqrt(triangles / 2.0))) + 1);
}

}  // namespace tamis::matrix

// Where all vertices of a path are.
#pragma once
#include <numeric>
#include <vector>

#include "tamis/path.hpp"

namespace tamis::io {

/// All vertices by their numbers.
inline std::vector<Index> vertices_of(const Path& path) {
  std::vector<Index> vertices(static_cast<std::size_t>(path.vertex_count()));
  std::iota(vertices.begin(), vertices.end(), 0);
  return vertices;
}

/// At a time in [0,1], rounded.
inline std::vector<Point> positions_at(const Path& path, double time) {
  const std::vector<Index> vertices = vertices_of(path);
  std::vector<Point> points(vertices.size());
  std::vector<double> errors(vertices.size());
  path.points_at(time, vertices, points, errors);
  return points;
}

}  // namespace tamis::io

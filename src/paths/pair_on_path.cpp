#include <algorithm>
#include <cmath>
#include <string>

#include "numerics/number_text.hpp"
#include "paths/decide_path.hpp"
#include "tamis/error.hpp"

namespace tamis {

void Path::fine_points_at(double time, std::span<const Index> vertices, std::span<FinePoint> points) const {
  std::vector<Point> high(vertices.size());
  std::vector<double> errors(vertices.size());
  points_at(time, vertices, high, errors);
  for (std::size_t i = 0; i < vertices.size(); ++i) points[i] = {high[i], {0, 0, 0}, errors[i]};
}

void Path::straight_directions(std::span<const Index>, std::span<Point> directions) const {
  std::fill(directions.begin(), directions.end(), Point{0, 0, 0});
}

namespace {

void validate(const PathOptions& options) {
  if (!(options.min_separation >= 0) || std::isinf(options.min_separation))
    throw InvalidOptions("the minimum separation is " + number_text(options.min_separation) +
                         ": give a finite distance >= 0");
  if (!(options.tolerance > 0 && options.tolerance <= 1))
    throw InvalidOptions("the tolerance of brackets is " + number_text(options.tolerance) +
                         ": give a fraction of the step, > 0 and <= 1");
}

template <std::size_t count>
PairResult decide_pair(PairKind kind, const Path& path, const std::array<Index, count>& used,
                       const PathOptions& options) {
  validate(options);
  PairVertices vertices{-1, -1, -1, -1};
  std::copy(used.begin(), used.end(), vertices.begin());
  for (const Index v : used)
    if (v < 0 || v >= path.vertex_count())
      throw InvalidPath("the path has no vertex " + std::to_string(v) + ": give numbers in [0, " +
                        std::to_string(path.vertex_count()) + ")");
  const PathQuestion question{path, kind, vertices, options.min_separation, options.tolerance, options.is_cancelled};
  return result_on_path(question, decide_on_path(question, {0, 1}));
}

}  // namespace

PairResult vertex_face(const Path& path, const std::array<Index, 4>& vertices, const PathOptions& options) {
  return decide_pair(PairKind::vertex_face, path, vertices, options);
}

PairResult edge_edge(const Path& path, const std::array<Index, 4>& vertices, const PathOptions& options) {
  return decide_pair(PairKind::edge_edge, path, vertices, options);
}

PairResult vertex_edge(const Path& path, const std::array<Index, 3>& vertices, const PathOptions& options) {
  return decide_pair(PairKind::vertex_edge, path, vertices, options);
}

PairResult vertex_vertex(const Path& path, const std::array<Index, 2>& vertices, const PathOptions& options) {
  return decide_pair(PairKind::vertex_vertex, path, vertices, options);
}

}  // namespace tamis

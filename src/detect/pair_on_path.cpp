#include <span>
#include <string>

#include "detect/validate.hpp"
#include "paths/decide_path.hpp"
#include "tamis/error.hpp"

namespace tamis {

namespace {

PairResult decide_pair(PairKind kind, const Path& path, const PairVertices& vertices, const PathOptions& options) {
  validate_of_path({.min_separation = options.min_separation, .tolerance = options.tolerance});
  for (const Index v : std::span(vertices).first(vertex_count(kind)))
    if (v < 0 || v >= path.vertex_count())
      throw InvalidPath("the path has no vertex " + std::to_string(v) + ": give numbers in [0, " +
                        std::to_string(path.vertex_count()) + ")");
  const PathQuestion question{
      path, kind, vertices_in_use(kind, vertices), options.min_separation, options.tolerance, options.is_cancelled};
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
  return decide_pair(PairKind::vertex_edge, path, {vertices[0], vertices[1], vertices[2]}, options);
}

PairResult vertex_vertex(const Path& path, const std::array<Index, 2>& vertices, const PathOptions& options) {
  return decide_pair(PairKind::vertex_vertex, path, {vertices[0], vertices[1]}, options);
}

}  // namespace tamis

// One pair by itself: given as points, or as vertices of a path.
#include "tamis/pair.hpp"

#include <algorithm>
#include <span>
#include <string>

#include "api/pair_faults.hpp"
#include "api/validate.hpp"
#include "curves/paths/callers_path.hpp"
#include "curves/paths/carried_pair.hpp"
#include "numbers/finite.hpp"
#include "numbers/floating_point_state.hpp"
#include "pair/narrow/decide.hpp"
#include "tamis/error.hpp"

namespace tamis {
namespace {

void check_finite(std::span<const Point> points, const char* when) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_finite(points[i].data())) throw InvalidStep(not_finite(i, when));
}

PairResult decide_points(PairKind kind, std::span<const Point> start, std::span<const Point> end,
                         const PairOptions& options) {
  const ComputingState state;
  check_finite(start, "start");
  check_finite(end, "end");
  validate(options);
  PairPoints points{};
  std::copy(start.begin(), start.end(), points.start.begin());
  std::copy(end.begin(), end.end(), points.end.begin());
  PrecisionCount decided_by;
  return decide({kind, points, options.min_separation}, decided_by, {options.latest});
}

PairResult decide_curves(PairKind kind, const Path& callers, const PairVertices& vertices, const PairOptions& options) {
  const ComputingState state;
  const CallersPath path(callers);
  validate(options);
  for (const Index v : std::span(vertices).first(vertex_count(kind)))
    if (v < 0 || v >= path.vertex_count())
      throw InvalidPath("the path has no vertex " + std::to_string(v) + ": give numbers in [0, " +
                        std::to_string(path.vertex_count()) + ")");
  const CarriedPair pair(path, kind, vertices_in_use(kind, vertices));
  const PathQuestion question{pair.path(),         kind, pair.vertices(), options.min_separation, options.tolerance,
                              options.is_cancelled};
  const Decision decision = decide_on_path(question, {0, 1});
  return decision.lower > options.latest ? PairResult{} : pair.in_world(result_on_path(question, decision));
}

}  // namespace

PairResult vertex_face(const std::array<Point, 4>& start, const std::array<Point, 4>& end, const PairOptions& options) {
  return decide_points(PairKind::vertex_face, start, end, options);
}
PairResult vertex_face(const Path& path, const std::array<Index, 4>& vertices, const PairOptions& options) {
  return decide_curves(PairKind::vertex_face, path, vertices, options);
}

PairResult edge_edge(const std::array<Point, 4>& start, const std::array<Point, 4>& end, const PairOptions& options) {
  return decide_points(PairKind::edge_edge, start, end, options);
}
PairResult edge_edge(const Path& path, const std::array<Index, 4>& vertices, const PairOptions& options) {
  return decide_curves(PairKind::edge_edge, path, vertices, options);
}

PairResult vertex_edge(const std::array<Point, 3>& start, const std::array<Point, 3>& end, const PairOptions& options) {
  return decide_points(PairKind::vertex_edge, start, end, options);
}
PairResult vertex_edge(const Path& path, const std::array<Index, 3>& vertices, const PairOptions& options) {
  return decide_curves(PairKind::vertex_edge, path, {vertices[0], vertices[1], vertices[2]}, options);
}

PairResult vertex_vertex(const std::array<Point, 2>& start, const std::array<Point, 2>& end,
                         const PairOptions& options) {
  return decide_points(PairKind::vertex_vertex, start, end, options);
}
PairResult vertex_vertex(const Path& path, const std::array<Index, 2>& vertices, const PairOptions& options) {
  return decide_curves(PairKind::vertex_vertex, path, {vertices[0], vertices[1]}, options);
}

}  // namespace tamis

#include "tamis/pair.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "narrow/decide.hpp"
#include "narrow/pair_input.hpp"
#include "numerics/finite.hpp"
#include "numerics/number_text.hpp"
#include "tamis/error.hpp"

namespace tamis {
namespace {

template <std::size_t count>
void check_finite(const std::array<Point, count>& points, const char* when) {
  for (std::size_t i = 0; i < count; ++i)
    if (!is_finite(points[i].data())) throw InvalidStep(not_finite(i, when));
}

template <std::size_t count>
PairResult decide_pair(PairKind kind, const std::array<Point, count>& start, const std::array<Point, count>& end,
                       const PairOptions& options) {
  check_finite(start, "start");
  check_finite(end, "end");
  validate(options);
  PairPoints points{};
  std::copy(start.begin(), start.end(), points.start.begin());
  std::copy(end.begin(), end.end(), points.end.begin());
  PrecisionCount decided_by;
  return decide(kind, points, options, decided_by);
}

}  // namespace

std::string not_finite(std::size_t point, const char* when) {
  return "point " + std::to_string(point) + " at the " + when + " of the step is not finite: give finite coordinates";
}

void validate(const PairOptions& options) {
  if (!(options.min_separation >= 0) || std::isinf(options.min_separation))
    throw InvalidOptions("the minimum separation is " + number_text(options.min_separation) +
                         ": give a finite distance >= 0");
  if (!(options.latest >= 0 && options.latest <= 1))
    throw InvalidOptions("the latest time of interest is " + number_text(options.latest) +
                         ": give a fraction of the step, >= 0 and <= 1");
}

PairResult vertex_face(const std::array<Point, 4>& start, const std::array<Point, 4>& end, const PairOptions& options) {
  return decide_pair(PairKind::vertex_face, start, end, options);
}

PairResult edge_edge(const std::array<Point, 4>& start, const std::array<Point, 4>& end, const PairOptions& options) {
  return decide_pair(PairKind::edge_edge, start, end, options);
}

PairResult vertex_edge(const std::array<Point, 3>& start, const std::array<Point, 3>& end, const PairOptions& options) {
  return decide_pair(PairKind::vertex_edge, start, end, options);
}

PairResult vertex_vertex(const std::array<Point, 2>& start, const std::array<Point, 2>& end,
                         const PairOptions& options) {
  return decide_pair(PairKind::vertex_vertex, start, end, options);
}

}  // namespace tamis

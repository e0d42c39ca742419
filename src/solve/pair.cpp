#include "tamis/pair.hpp"

#include <cmath>
#include <string>

#include "solve/decide.hpp"
#include "tamis/error.hpp"

namespace tamis {
namespace {

void check_finite(const std::array<Point, 4>& points, const char* when) {
  for (std::size_t i = 0; i < 4; ++i)
    for (double c : points[i])
      if (!std::isfinite(c))
        throw InvalidStep("point " + std::to_string(i) + " at the " + when +
                          " of the step is not finite: give finite coordinates");
}

PairResult decide_pair(PairKind kind, const std::array<Point, 4>& start, const std::array<Point, 4>& end,
                       const PairOptions& options) {
  check_finite(start, "start");
  check_finite(end, "end");
  if (!(options.min_separation >= 0) || std::isinf(options.min_separation))
    throw InvalidOptions("the minimum separation is " + std::to_string(options.min_separation) +
                         ": give a finite distance >= 0");
  PrecisionCount decided_by;
  return decide(kind, {start, end}, options, decided_by);
}

}  // namespace

PairResult vertex_face(const std::array<Point, 4>& start, const std::array<Point, 4>& end, const PairOptions& options) {
  return decide_pair(PairKind::vertex_face, start, end, options);
}

PairResult edge_edge(const std::array<Point, 4>& start, const std::array<Point, 4>& end, const PairOptions& options) {
  return decide_pair(PairKind::edge_edge, start, end, options);
}

}  // namespace tamis

// Edges that move in one plane orthogonal to a coordinate axis, as all of a 2D simulation do. Such edges are always
// coplanar, so a crossing does not tell when they touch. But they touch first where an end of one comes to the other
// edge. There the other edge crosses the upright: the line through that end orthogonal to the plane.
#include <algorithm>
#include <cmath>

#include "pair/distance/turning_gap.hpp"
#include "pair/narrow/decisions.hpp"

namespace tamis {
namespace {

/// The axis along which all four points have one coordinate at the start, and one at the end; 3 if there is none.
std::size_t shared_coordinate(const PairPoints& points) {
  const auto is_shared = [](const std::array<Point, 4>& p, std::size_t k) {
    return p[0][k] == p[1][k] && p[0][k] == p[2][k] && p[0][k] == p[3][k];
  };
  std::size_t k = 0;
  while (k < 3 && !(is_shared(points.start, k) && is_shared(points.end, k))) ++k;
  return k;
}

/// The points of the edges, with the edge of `end` replaced by the upright: a line through that end along `axis`. Each
/// half of the upright is as long as the largest coordinate. So neither of its ends is rounded into the plane.
PairPoints with_upright(const PairPoints& points, std::size_t end, std::size_t axis) {
  double height = 0;
  for (const auto* at : {&points.start, &points.end})
    for (const Point& p : *at)
      for (const double x : p) height = std::max(height, std::fabs(x));
  const auto replaced = [&](std::array<Point, 4> p) {
    const std::size_t first = end & ~std::size_t{1};
    const Point middle = p[end];
    p[first] = p[first + 1] = middle;
    p[first][axis] -= height;
    p[first + 1][axis] += height;
    return p;
  };
  return {replaced(points.start), replaced(points.end)};
}

/// An end of an edge comes to the other edge at this crossing of its upright.
struct Meeting {
  std::size_t end;
  PairResult crossing;

  /// The pair's answer: the bracket that integers would give, and weights on its own edges. Nothing if that is
  /// unproven.
  std::optional<PairResult> described(const PairPoints& points, std::size_t axis) const {
    const PairPoints upright = with_upright(points, end, axis);
    const auto time = decide_crossing_finely({PairKind::edge_edge, upright},
                                             {Verdict::touches, crossing.toi_lower, crossing.toi_upper});
    if (!time) return {};
    PairResult result = crossing;
    result.toi_lower = time->lower;
    result.toi_upper = time->upper;
    (end < 2 ? result.u : result.v) = static_cast<double>(end % 2);
    return result;
  }
};

bool may_be_at_once(const PairResult& a, const PairResult& b) {
  return a.toi_lower <= b.toi_upper && b.toi_lower <= a.toi_upper;
}

}  // namespace

std::optional<PairResult> decided_in_plane(const PairInStep& pair) {
  if (pair.kind != PairKind::edge_edge || pair.separation > 0 || !is_finite(pair.motion)) return {};
  const std::size_t axis = shared_coordinate(pair.points);
  if (axis == 3) return {};
  const TurningGap<PairKind::edge_edge, double> gap(pair.motion);
  if (!gap.stays_apart({0, 0}, 1)) return {};
  std::optional<Meeting> first;
  for (std::size_t end = 0; end < 4; ++end) {
    const PairPoints upright = with_upright(pair.points, end, axis);
    if (!is_finite(upright)) return {};
    const auto crossing = decided_by_crossings(PairInStep(PairKind::edge_edge, upright), 1);
    if (!crossing) return {};
    if (!crossing->touches) continue;
    if (first && may_be_at_once(first->crossing, *crossing)) return {};
    if (!first || crossing->toi_lower < first->crossing.toi_lower) first = {end, *crossing};
  }
  return first ? first->described(pair.points, axis) : PairResult{};
}

}  // namespace tamis

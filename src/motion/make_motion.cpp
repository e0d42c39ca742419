#include "motion/make_motion.hpp"

#include <algorithm>
#include <cmath>

#include "motion/pair_kinds.hpp"
#include "numerics/scale.hpp"

namespace tamis {
namespace {

/// 1, unless differences might overflow: then a power of two that keeps them below 2^1022. What is so small that it
/// loses bits by that is far below `underflow`.
double safe_unit(const PairPoints& points) {
  double largest = 0;
  for (const auto* positions : {&points.start, &points.end})
    for (const Point& p : *positions)
      for (const double x : p) largest = std::max(largest, std::fabs(x));
  return largest < 0x1p1021 ? 1 : 0x1p-3;
}

Moving<double> scaled(const Moving<double>& v, double scale) { return {scale * v.at0, scale * v.at1}; }

Moving<double> difference(const PairPoints& points, VertexDifference v, double unit) {
  const auto at = [&](const std::array<Point, 4>& p) {
    const Point &to = p[static_cast<std::size_t>(v.to)], &from = p[static_cast<std::size_t>(v.from)];
    const auto along = [&](std::size_t k) { return unit * to[k] - unit * from[k]; };
    return Vec3<double>{along(0), along(1), along(2)};
  };
  return {at(points.start), at(points.end)};
}

}  // namespace

PairMotion<double> make_motion(PairKind kind, const PairPoints& points, double separation) {
  const SpanningVectors vectors = spanning_vectors(kind);
  const double unit = safe_unit(points);
  const auto e = difference(points, vectors.e, unit), f = difference(points, vectors.f, unit),
             d = difference(points, vectors.d, unit);
  const double scale = scale_below_one(std::max({largest(e), largest(f), largest(d)}));
  return {scaled(e, scale),   scaled(f, scale),   scaled(d, scale),           scale * largest(e),
          scale * largest(f), scale * largest(d), scale * (unit * separation)};
}

}  // namespace tamis

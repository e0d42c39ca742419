#include "motion/make_motion.hpp"

#include <algorithm>
#include <cmath>

#include "motion/pair_kinds.hpp"
#include "numerics/assert.hpp"
#include "numerics/finite.hpp"
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

bool are_equal(const Vec3<double>& a, const Vec3<double>& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

bool are_equal(const Moving<double>& a, const Moving<double>& b) {
  return are_equal(a.at0, b.at0) && are_equal(a.at1, b.at1);
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
  TAMIS_ASSERT(is_kind(kind) && is_finite(points) && separation >= 0);
  const SpanningVectors vectors = spanning_vectors(kind);
  const double unit = safe_unit(points);
  const auto e = difference(points, vectors.e, unit), f = difference(points, vectors.f, unit),
             d = difference(points, vectors.d, unit);
  const double scale = scale_below_one(std::max({largest(e), largest(f), largest(d)}));
  return {scaled(e, scale),   scaled(f, scale),   scaled(d, scale),           scale * largest(e),
          scale * largest(f), scale * largest(d), scale * (unit * separation)};
}

bool is_finite(const PairPoints& points) {
  const auto are_finite = [](const std::array<Point, 4>& at) {
    return std::all_of(at.begin(), at.end(), [](const Point& p) { return is_finite(p); });
  };
  return are_finite(points.start) && are_finite(points.end);
}

bool is_motion_of(const PairMotion<double>& m, PairKind kind, const PairPoints& points) {
  const PairMotion<double> own = make_motion(kind, points);
  return are_equal(m.e, own.e) && are_equal(m.f, own.f) && are_equal(m.d, own.d);
}

}  // namespace tamis

#include "motion/make_motion.hpp"

#include <algorithm>
#include <cmath>

#include "motion/pair_kinds.hpp"
#include "numerics/scale.hpp"

namespace tamis {
namespace {

/// The sizes are those of the differences in doubles.
double largest(const Moving<DoubleDouble>& v) {
  const auto rounded = [](const Vec3<DoubleDouble>& x) { return Vec3<double>{x.x.high, x.y.high, x.z.high}; };
  return tamis::largest({rounded(v.at0), rounded(v.at1)});
}

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

Moving<DoubleDouble> scaled(const Moving<DoubleDouble>& v, double scale) {
  const auto part = [&](const DoubleDouble& x) { return DoubleDouble{scale * x.high, scale * x.low}; };
  const auto vector = [&](const Vec3<DoubleDouble>& x) { return Vec3<DoubleDouble>{part(x.x), part(x.y), part(x.z)}; };
  return {vector(v.at0), vector(v.at1)};
}

template <class T>
Moving<T> difference(const PairPoints& points, VertexDifference v, double unit) {
  const auto at = [&](const std::array<Point, 4>& p) {
    const Point &to = p[static_cast<std::size_t>(v.to)], &from = p[static_cast<std::size_t>(v.from)];
    const auto along = [&](std::size_t k) { return T(unit * to[k]) - T(unit * from[k]); };
    return Vec3<T>{along(0), along(1), along(2)};
  };
  return {at(points.start), at(points.end)};
}

/// `unit` and `scale` are powers of two.
template <class T>
PairMotion<T> motion_of(PairKind kind, const PairPoints& points, double separation, double unit) {
  const SpanningVectors vectors = spanning_vectors(kind);
  const auto vector = [&](VertexDifference v) { return difference<T>(points, v, unit); };
  const auto e = vector(vectors.e), f = vector(vectors.f), d = vector(vectors.d);
  const double size_e = largest(e), size_f = largest(f), size_d = largest(d);
  const double scale = scale_below_one(std::max({size_e, size_f, size_d}));
  return {scaled(e, scale), scaled(f, scale), scaled(d, scale),           scale * size_e,
          scale * size_f,   scale * size_d,   scale * (unit * separation)};
}

}  // namespace

PairMotion<double> make_motion(PairKind kind, const PairPoints& points, double separation) {
  return motion_of<double>(kind, points, separation, safe_unit(points));
}

PairMotion<DoubleDouble> make_fine_motion(PairKind kind, const PairPoints& points, double separation) {
  return motion_of<DoubleDouble>(kind, points, separation, safe_unit(points));
}

}  // namespace tamis

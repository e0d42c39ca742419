#include "motion/make_motion.hpp"

#include <algorithm>
#include <cmath>

#include "motion/pair_kinds.hpp"
#include "numerics/scale.hpp"

namespace tamis {
namespace {

/// Takes differences of positions times `unit`.
struct Difference {
  double unit;
  Vec3<double> operator()(const Point& to, const Point& from) const {
    const auto along = [&](std::size_t k) { return unit * to[k] - unit * from[k]; };
    return {along(0), along(1), along(2)};
  }
};
struct ExactDifference {
  double unit;
  Vec3<DoubleDouble> operator()(const Point& to, const Point& from) const {
    const auto along = [&](std::size_t k) { return DoubleDouble::sum_of(unit * to[k], -(unit * from[k])); };
    return {along(0), along(1), along(2)};
  }
};

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

/// By a power of two: exact.
Vec3<DoubleDouble> scaled(const Vec3<DoubleDouble>& v, double scale) {
  const auto times = [&](const DoubleDouble& x) { return DoubleDouble(scale * x.high, scale * x.low); };
  return {times(v.x), times(v.y), times(v.z)};
}
Moving<DoubleDouble> scaled(const Moving<DoubleDouble>& v, double scale) {
  return {scaled(v.at0, scale), scaled(v.at1, scale)};
}

/// |components| of a difference whose rounded ones are at most `size`.
DoubleDouble bound_of(double size) { return size * (1 + 0x1p-52); }

template <class T>
struct Vectors {
  Moving<T> e, f, d;
};

/// `difference`: of two positions at one end of the step.
template <class T, class Difference>
inline Vectors<T> vectors_of(PairKind kind, const PairPoints& points, const Difference& difference) {
  const auto moving = [&](VertexDifference v) {
    const auto to = static_cast<std::size_t>(v.to), from = static_cast<std::size_t>(v.from);
    return Moving<T>{difference(points.start[to], points.start[from]), difference(points.end[to], points.end[from])};
  };
  const SpanningVectors vectors = spanning_vectors(kind);
  return {moving(vectors.e), moving(vectors.f), moving(vectors.d)};
}

double scale_of(const Vectors<double>& v) {
  return scale_below_one(std::max({largest(v.e), largest(v.f), largest(v.d)}));
}

}  // namespace

PairMotion<double> make_motion(PairKind kind, const PairPoints& points, double separation) {
  const double unit = safe_unit(points);
  const auto [e, f, d] = vectors_of<double>(kind, points, Difference{unit});
  const double scale = scale_of({e, f, d});
  return {scaled(e, scale),   scaled(f, scale),   scaled(d, scale),           scale * largest(e),
          scale * largest(f), scale * largest(d), scale * (unit * separation)};
}

PairMotion<DoubleDouble> make_extended_motion(PairKind kind, const PairPoints& points) {
  const double unit = safe_unit(points);
  const auto rounded = vectors_of<double>(kind, points, Difference{unit});
  const double scale = scale_of(rounded);
  const auto [e, f, d] = vectors_of<DoubleDouble>(kind, points, ExactDifference{unit});
  return {scaled(e, scale),
          scaled(f, scale),
          scaled(d, scale),
          bound_of(scale * largest(rounded.e)),
          bound_of(scale * largest(rounded.f)),
          bound_of(scale * largest(rounded.d))};
}

}  // namespace tamis

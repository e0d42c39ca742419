#include "pair/motion/make_motion.hpp"

#include <algorithm>
#include <cmath>

#include "numbers/assert.hpp"
#include "numbers/finite.hpp"
#include "numbers/scale.hpp"
#include "pair/motion/pair_kinds.hpp"

namespace tamis {
namespace {

using tamis::largest;
/// Of the differences rounded to doubles.
double largest(const Moving<DoubleDouble>& v) { return largest(Moving<double>{rounded(v.at0), rounded(v.at1)}); }

/// 1, unless differences might overflow. Then a power of two that keeps them below 2^1022. Coordinates small enough to
/// lose bits by that are far below `underflow`.
double safe_unit(const PairPoints& points) {
  double largest = 0;
  for (const auto* positions : {&points.start, &points.end})
    for (const Point& p : *positions)
      for (const double x : p) largest = std::max(largest, std::fabs(x));
  return largest < 0x1p1021 ? 1 : 0x1p-3;
}

template <class T>
Moving<T> scaled(double power, const Moving<T>& v) {
  return {scaled(power, v.at0), scaled(power, v.at1)};
}

template <class T>
Moving<T> moving_difference(const PairPoints& points, VertexDifference v, double unit) {
  const auto at = [&](const std::array<Point, 4>& p) {
    const Point &to = p[v.to], &from = p[v.from];
    const auto along = [&](std::size_t k) { return T(unit * to[k]) - T(unit * from[k]); };
    return Vec3<T>{along(0), along(1), along(2)};
  };
  return {at(points.start), at(points.end)};
}

/// A motion in the unit of the points times a power of two.
template <class T>
struct Unscaled {
  Moving<T> e, f, d;
  double separation;

  double size() const { return std::max({largest(e), largest(f), largest(d)}); }
  PairMotion<T> times(double scale) const {
    return {scaled(scale, e),   scaled(scale, f),   scaled(scale, d),  scale * largest(e),
            scale * largest(f), scale * largest(d), scale * separation};
  }
};

template <class T>
Unscaled<T> unscaled(PairKind kind, const PairPoints& points, double separation) {
  const SpanningVectors vectors = spanning_vectors(kind);
  const double unit = safe_unit(points);
  const auto vector = [&](VertexDifference v) { return moving_difference<T>(points, v, unit); };
  return {vector(vectors.e), vector(vectors.f), vector(vectors.d), unit * separation};
}

template <class T>
PairMotion<T> motion_of(PairKind kind, const PairPoints& points, double separation) {
  const auto motion = unscaled<T>(kind, points, separation);
  return motion.times(scale_below_one(motion.size()));
}

/// A vector at t=0 and at t=part, rounded once.
Moving<double> beginning(const Moving<DoubleDouble>& v, double part) {
  return {rounded(v.at0), rounded(v.at0 + scaled(part, v.at1 - v.at0))};
}

}  // namespace

PairMotion<double> make_motion(PairKind kind, const PairPoints& points, double separation) {
  TAMIS_ASSERT(is_kind(kind) && is_finite(points) && separation >= 0);
  return motion_of<double>(kind, points, separation);
}

PairMotion<DoubleDouble> make_fine_motion(const PairInStep& pair) {
  return motion_of<DoubleDouble>(pair.kind, pair.points, pair.separation);
}

std::optional<PairMotion<double>> make_beginning(const PairInStep& pair, double part) {
  TAMIS_ASSERT(0 < part && part <= 1);
  constexpr double kMostScale = 0x1p60;
  const auto whole = unscaled<DoubleDouble>(pair.kind, pair.points, pair.separation);
  const Unscaled<double> motion{beginning(whole.e, part), beginning(whole.f, part), beginning(whole.d, part),
                                whole.separation};
  const double scale = scale_below_one(motion.size());
  if (scale > kMostScale) return {};
  return motion.times(scale);
}

bool is_finite(const PairPoints& points) {
  const auto are_finite = [](const std::array<Point, 4>& at) {
    return std::all_of(at.begin(), at.end(), [](const Point& p) { return is_finite(p); });
  };
  return are_finite(points.start) && are_finite(points.end);
}

}  // namespace tamis

#include "exact/moving_polygon.hpp"

#include <algorithm>
#include <bit>
#include <climits>
#include <cmath>
#include <cstdint>

#include "motion/pair_kinds.hpp"
#include "numerics/assert.hpp"

namespace tamis {
namespace {

/// x = mantissa 2^exponent.
struct Parts {
  std::int64_t mantissa;
  int exponent;
};

Parts parts_of(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto biased = static_cast<int>(bits >> 52 & 0x7ff);
  auto mantissa = static_cast<std::int64_t>(bits & 0xfffffffffffff);
  if (biased > 0) mantissa |= std::int64_t{1} << 52;
  return {x < 0 ? -mantissa : mantissa, std::max(biased, 1) - 1075};
}

/// Of the last bit that is set; INT_MAX for zero.
int lowest_exponent(double x) {
  if (x == 0) return INT_MAX;
  const Parts parts = parts_of(x);
  return parts.exponent + std::countr_zero(static_cast<std::uint64_t>(parts.mantissa));
}

/// By axis.
using Exponents = std::array<int, 3>;

/// Of each axis' coordinates; INT_MAX for one that has no bit.
Exponents lowest_exponents(const PairPoints& points) {
  Exponents lowest{INT_MAX, INT_MAX, INT_MAX};
  for (const auto* at : {&points.start, &points.end})
    for (const Point& point : *at)
      for (std::size_t k = 0; k < 3; ++k) lowest[k] = std::min(lowest[k], lowest_exponent(point[k]));
  return lowest;
}

template <class Number>
MovingPolygonOf<Number> polygon(PairKind kind, const PairPoints& points, const Exponents& units) {
  const auto vector = [&](const Point& p) {
    return Vec3<Number>{scaled_to_integer<Number>(p[0], units[0]), scaled_to_integer<Number>(p[1], units[1]),
                        scaled_to_integer<Number>(p[2], units[2])};
  };
  const auto moving = [&](std::size_t i) { return Moving<Number>{vector(points.start[i]), vector(points.end[i])}; };
  const std::array<Moving<Number>, 4> x{moving(0), moving(1), moving(2), moving(3)};
  switch (kind) {
    case PairKind::vertex_face:
      return {{x[0] - x[1], x[0] - x[2], x[0] - x[3], {}}, 3, units[0]};
    case PairKind::edge_edge:
      return {{x[2] - x[0], x[2] - x[1], x[3] - x[1], x[3] - x[0]}, 4, units[0]};
    case PairKind::vertex_edge:
      return {{x[0] - x[1], x[0] - x[2], {}, {}}, 2, units[0]};
    case PairKind::vertex_vertex:
      break;
  }
  return {{x[0] - x[1], {}, {}, {}}, 1, units[0]};
}

}  // namespace

template <class Number>
Number scaled_to_integer(double x, int exponent) {
  if (x == 0) return 0;
  const Parts parts = parts_of(x);
  TAMIS_ASSERT(std::isfinite(x) && lowest_exponent(x) >= exponent);
  return Number::scaled(parts.mantissa, parts.exponent - exponent);
}
template Integer scaled_to_integer(double, int);
template Estimate scaled_to_integer(double, int);

template <class Number>
MovingPolygonOf<Number> difference_polygon(PairKind kind, const PairPoints& points, double separation) {
  TAMIS_ASSERT(is_kind(kind) && is_finite(points) && std::isfinite(separation));
  const Exponents lowest = lowest_exponents(points);
  const int common = std::min({lowest[0], lowest[1], lowest[2], lowest_exponent(separation)});
  const int unit = common == INT_MAX ? 0 : common;
  return polygon<Number>(kind, points, {unit, unit, unit});
}
template MovingPolygonOf<Integer> difference_polygon(PairKind, const PairPoints&, double);
template MovingPolygonOf<Estimate> difference_polygon(PairKind, const PairPoints&, double);

MovingPolygon at_rest_at(const MovingPolygon& polygon, const DyadicCell& time) {
  const Integer before = (Integer(1) << time.k) - time.n;
  MovingPolygon resting{{}, polygon.corner_count, polygon.exponent - static_cast<int>(time.k)};
  for (std::size_t i = 0; i < polygon.corner_count; ++i) {
    const auto& [at0, at1] = polygon.corners[i];
    const Vec3<Integer> at = before * at0 + time.n * at1;
    resting.corners[i] = {at, at};
  }
  return resting;
}

MovingPolygon stretched_polygon(PairKind kind, const PairPoints& points) {
  TAMIS_ASSERT(is_kind(kind) && is_finite(points));
  return polygon<Integer>(kind, points, lowest_exponents(points));
}

}  // namespace tamis

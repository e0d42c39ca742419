#include "exact/moving_polygon.hpp"

#include <algorithm>
#include <bit>
#include <climits>
#include <cmath>
#include <cstdint>
#include <span>

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

/// The lower of each and of those of the points' coordinates; INT_MAX for an axis that has no bit.
Exponents lowest_exponents(std::span<const Point> points, Exponents lowest = {INT_MAX, INT_MAX, INT_MAX}) {
  for (const Point& point : points)
    for (std::size_t k = 0; k < 3; ++k) lowest[k] = std::min(lowest[k], lowest_exponent(point[k]));
  return lowest;
}

/// The lowest of all, also of the separation's, for each axis.
Exponents common_unit(const Exponents& lowest, double separation) {
  const int common = std::min({lowest[0], lowest[1], lowest[2], lowest_exponent(separation)});
  const int unit = common == INT_MAX ? 0 : common;
  return {unit, unit, unit};
}

template <class Number>
Vec3<Number> scaled_to_integers(const Point& p, const Exponents& units) {
  return {scaled_to_integer<Number>(p[0], units[0]), scaled_to_integer<Number>(p[1], units[1]),
          scaled_to_integer<Number>(p[2], units[2])};
}

/// Points whose coordinates are integers in one unit, of 2^exponent.
template <std::size_t count>
struct InWords {
  std::array<Vec3<Word>, count> points;
  int exponent;
};

/// In the largest unit in which they and the separation are whole, if 61 bits hold them then: tried is a unit of 2^-61
/// of the largest, and the last bits are taken off that none has set.
template <std::size_t count>
std::optional<InWords<count>> in_words(const std::array<Point, count>& points, double separation) {
  double largest = separation;
  for (const Point& p : points)
    for (const double x : p) largest = std::max(largest, std::fabs(x));
  const int power = 8 - parts_of(largest).exponent;  // a mantissa has 53 bits
  if (largest == 0 || std::abs(power) > 900) return {};
  const double factor = times_power_of_two(1, power);
  std::int64_t set = 0;
  bool are_whole = true;
  const auto word = [&](double x) {
    const double scaled = x * factor;
    const auto integer = static_cast<std::int64_t>(scaled);
    are_whole = are_whole && static_cast<double>(integer) == scaled && (integer != 0 || x == 0);
    set |= integer;
    return Word{integer};
  };
  InWords<count> result;
  word(separation);
  for (std::size_t i = 0; i < count; ++i)
    result.points[i] = {word(points[i][0]), word(points[i][1]), word(points[i][2])};
  if (!are_whole) return {};
  const int unset = std::countr_zero(static_cast<std::uint64_t>(set));
  for (auto& [x, y, z] : result.points)
    for (Word* w : {&x, &y, &z}) w->value >>= unset;
  result.exponent = unset - power;
  return result;
}

/// Of the features' vertices.
template <class Corner>
PolygonOf<Corner> polygon_of(PairKind kind, const std::array<Corner, 4>& x, int exponent) {
  const auto corners = difference_corners(kind);
  PolygonOf<Corner> polygon{{}, corners.size(), exponent};
  for (std::size_t i = 0; i < corners.size(); ++i) polygon.corners[i] = x[corners[i].to] - x[corners[i].from];
  return polygon;
}

template <class Number>
Polygon<Number> polygon_in(const Polygon<Word>& words) {
  Polygon<Number> polygon{{}, words.corner_count, words.exponent};
  for (std::size_t i = 0; i < words.corner_count; ++i) polygon.corners[i] = as<Number>(words.corners[i]);
  return polygon;
}

MovingPolygon moving_polygon(PairKind kind, const PairPoints& points, const Exponents& units) {
  const auto at = [&](std::size_t i) {
    return Moving<Integer>{scaled_to_integers<Integer>(points.start[i], units),
                           scaled_to_integers<Integer>(points.end[i], units)};
  };
  return polygon_of<Moving<Integer>>(kind, {at(0), at(1), at(2), at(3)}, units[0]);
}

Exponents lowest_exponents(const PairPoints& points) {
  return lowest_exponents(points.end, lowest_exponents(points.start));
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

MovingPolygon difference_polygon(PairKind kind, const PairPoints& points, double separation) {
  TAMIS_ASSERT(is_kind(kind) && is_finite(points) && std::isfinite(separation));
  return moving_polygon(kind, points, common_unit(lowest_exponents(points), separation));
}

MovingPolygon stretched_polygon(PairKind kind, const PairPoints& points) {
  TAMIS_ASSERT(is_kind(kind) && is_finite(points));
  return moving_polygon(kind, points, lowest_exponents(points));
}

std::optional<Polygon<Word>> start_polygon_in_words(PairKind kind, const PairPoints& points, double separation) {
  TAMIS_ASSERT(is_kind(kind) && is_finite(points) && std::isfinite(separation));
  const auto words = in_words(points.start, separation);
  if (!words) return {};
  return polygon_of<Vec3<Word>>(kind, words->points, words->exponent);
}

template <class Number>
Polygon<Number> start_polygon(PairKind kind, const PairPoints& points, double separation) {
  TAMIS_ASSERT(is_kind(kind) && is_finite(points) && std::isfinite(separation));
  const Exponents units = common_unit(lowest_exponents(points.start), separation);
  const auto at = [&](std::size_t i) { return scaled_to_integers<Number>(points.start[i], units); };
  return polygon_of<Vec3<Number>>(kind, {at(0), at(1), at(2), at(3)}, units[0]);
}
template Polygon<Integer> start_polygon(PairKind, const PairPoints&, double);
template Polygon<Estimate> start_polygon(PairKind, const PairPoints&, double);

template <class Number>
Polygon<Number> corner_velocities(PairKind kind, const PairPoints& points) {
  TAMIS_ASSERT(is_kind(kind) && is_finite(points));
  const auto& [start, end] = points;
  if (const auto words = in_words<8>({start[0], start[1], start[2], start[3], end[0], end[1], end[2], end[3]}, 0)) {
    const auto& x = words->points;
    return polygon_in<Number>(
        polygon_of<Vec3<Word>>(kind, {x[4] - x[0], x[5] - x[1], x[6] - x[2], x[7] - x[3]}, words->exponent));
  }
  const Exponents units = common_unit(lowest_exponents(points), 0);
  const auto of = [&](std::size_t i) {
    return scaled_to_integers<Number>(end[i], units) - scaled_to_integers<Number>(start[i], units);
  };
  return polygon_of<Vec3<Number>>(kind, {of(0), of(1), of(2), of(3)}, units[0]);
}
template Polygon<Integer> corner_velocities(PairKind, const PairPoints&);
template Polygon<Estimate> corner_velocities(PairKind, const PairPoints&);

Polygon<Integer> polygon_at(const MovingPolygon& polygon, const DyadicCell& time) {
  const Integer before = (Integer(1) << time.k) - time.n;
  Polygon<Integer> at{{}, polygon.corner_count, polygon.exponent - static_cast<int>(time.k)};
  for (std::size_t i = 0; i < polygon.corner_count; ++i)
    at.corners[i] = before * polygon.corners[i].at0 + time.n * polygon.corners[i].at1;
  return at;
}

}  // namespace tamis

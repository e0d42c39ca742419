// The largest unit that makes coordinates integers, so the integers are short. Also gives coordinates as words of 61
// bits.
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <climits>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

#include "numbers/word.hpp"
#include "pair/motion/make_motion.hpp"

namespace tamis {

/// x = mantissa 2^exponent.
struct Parts {
  std::int64_t mantissa;
  int exponent;
};

inline Parts parts_of(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto biased = static_cast<int>(bits >> 52 & 0x7ff);
  auto mantissa = static_cast<std::int64_t>(bits & 0xfffffffffffff);
  if (biased > 0) mantissa |= std::int64_t{1} << 52;
  return {x < 0 ? -mantissa : mantissa, std::max(biased, 1) - 1075};
}

/// The exponent of the last bit that is set; INT_MAX for zero.
inline int lowest_exponent(double x) {
  if (x == 0) return INT_MAX;
  const Parts parts = parts_of(x);
  return parts.exponent + std::countr_zero(static_cast<std::uint64_t>(parts.mantissa));
}

/// One for each axis.
using Exponents = std::array<int, 3>;

/// For each axis the lowest of `lowest` and the lowest_exponent() of the points' coordinates. INT_MAX if all are zero.
inline Exponents lowest_exponents(std::span<const Point> points, Exponents lowest = {INT_MAX, INT_MAX, INT_MAX}) {
  for (const Point& point : points)
    for (std::size_t k = 0; k < 3; ++k) lowest[k] = std::min(lowest[k], lowest_exponent(point[k]));
  return lowest;
}

inline Exponents lowest_exponents(const PairPoints& points) {
  return lowest_exponents(points.end, lowest_exponents(points.start));
}

/// The lowest of all axes and of the separation, for each axis; 0 if all are zero.
inline Exponents common_unit(const Exponents& lowest, double separation) {
  const int common = std::min({lowest[0], lowest[1], lowest[2], lowest_exponent(separation)});
  const int unit = common == INT_MAX ? 0 : common;
  return {unit, unit, unit};
}

/// Points whose coordinates are integers in the unit 2^exponent.
template <std::size_t count>
struct InWords {
  std::array<Vec3<Word>, count> points;
  int exponent;
};

/// The points in the largest unit that makes them and the separation whole. Nothing if 61 bits do not hold them then,
/// or if all are zero. Tries a unit of 2^-61 of the largest, then takes off the last bits that no number has set.
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

}  // namespace tamis

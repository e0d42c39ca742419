#include "solve/moving_polygon.hpp"

#include <algorithm>
#include <bit>
#include <climits>
#include <cmath>
#include <cstdint>

namespace tamis {
namespace {

constexpr int kDigits = 53;

/// x = mantissa 2^exponent with an odd mantissa, or zero.
int exponent_of_last_bit(double x) {
  int exponent;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), kDigits));
  return exponent - kDigits + std::countr_zero(static_cast<std::uint64_t>(mantissa));
}

int common_exponent(const PairPoints& points) {
  int common = INT_MAX;
  for (const auto* at : {&points.start, &points.end})
    for (const Point& point : *at)
      for (const double x : point)
        if (x != 0) common = std::min(common, exponent_of_last_bit(x));
  return common;
}

Integer scaled(double x, int common) {
  if (x == 0) return 0;
  int exponent;
  Integer result(std::ldexp(std::frexp(x, &exponent), kDigits));
  const int shift = exponent - kDigits - common;
  if (shift >= 0)
    result <<= static_cast<unsigned long>(shift);
  else
    result >>= static_cast<unsigned long>(-shift);
  return result;
}

std::array<Moving<Integer>, 4> scaled(const PairPoints& points) {
  const int common = common_exponent(points);
  const auto vector = [common](const Point& p) {
    return Vec3<Integer>{scaled(p[0], common), scaled(p[1], common), scaled(p[2], common)};
  };
  std::array<Moving<Integer>, 4> result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = {vector(points.start[i]), vector(points.end[i])};
  return result;
}

}  // namespace

MovingPolygon difference_polygon(PairKind kind, const PairPoints& points) {
  const auto x = scaled(points);
  if (kind == PairKind::vertex_face) return {{x[0] - x[1], x[0] - x[2], x[0] - x[3], {}}, 3};
  return {{x[2] - x[0], x[2] - x[1], x[3] - x[1], x[3] - x[0]}, 4};
}

}  // namespace tamis

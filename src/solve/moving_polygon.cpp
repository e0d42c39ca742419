#include "solve/moving_polygon.hpp"

#include <algorithm>
#include <bit>
#include <climits>
#include <cstdint>

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

/// Of all coordinates and the separation; 0 if none has a bit.
int common_exponent(const PairPoints& points, double separation) {
  int common = lowest_exponent(separation);
  for (const auto* at : {&points.start, &points.end})
    for (const Point& point : *at)
      for (const double x : point) common = std::min(common, lowest_exponent(x));
  return common == INT_MAX ? 0 : common;
}

std::array<Moving<Integer>, 4> scaled(const PairPoints& points, int common) {
  const auto vector = [common](const Point& p) {
    return Vec3<Integer>{scaled_to_integer(p[0], common), scaled_to_integer(p[1], common),
                         scaled_to_integer(p[2], common)};
  };
  std::array<Moving<Integer>, 4> result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = {vector(points.start[i]), vector(points.end[i])};
  return result;
}

}  // namespace

Integer scaled_to_integer(double x, int exponent) {
  if (x == 0) return 0;
  const Parts parts = parts_of(x);
  const int shift = parts.exponent - exponent;
  if (shift <= 0) return parts.mantissa / (std::int64_t{1} << -shift);
  return Integer(parts.mantissa) << static_cast<unsigned long>(shift);
}

MovingPolygon difference_polygon(PairKind kind, const PairPoints& points, double separation) {
  const int common = common_exponent(points, separation);
  const auto x = scaled(points, common);
  switch (kind) {
    case PairKind::vertex_face:
      return {{x[0] - x[1], x[0] - x[2], x[0] - x[3], {}}, 3, common};
    case PairKind::edge_edge:
      return {{x[2] - x[0], x[2] - x[1], x[3] - x[1], x[3] - x[0]}, 4, common};
    case PairKind::vertex_edge:
      return {{x[0] - x[1], x[0] - x[2], {}, {}}, 2, common};
    case PairKind::vertex_vertex:
      break;
  }
  return {{x[0] - x[1], {}, {}, {}}, 1, common};
}

}  // namespace tamis

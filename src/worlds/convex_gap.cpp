#include "worlds/convex_gap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tamis {
namespace {

constexpr double kNoGap = -std::numeric_limits<double>::infinity();

Point scaled(const Point& a, double factor) { return {a[0] * factor, a[1] * factor, a[2] * factor}; }
Point sum_of(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

/// The closest point of a triangle (Ericson 2005, 5.1.5).
Point closest_on(const Triangle& t, const Point& p) {
  const Point ab = difference(t[1], t[0]), ac = difference(t[2], t[0]), ap = difference(p, t[0]);
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return t[0];
  const Point bp = difference(p, t[1]);
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return t[1];
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return sum_of(t[0], scaled(ab, d1 / (d1 - d3)));
  const Point cp = difference(p, t[2]);
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return t[2];
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return sum_of(t[0], scaled(ac, d2 / (d2 - d6)));
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return sum_of(t[1], scaled(difference(t[2], t[1]), (d4 - d3) / ((d4 - d3) + (d5 - d6))));
  const double scale = 1 / (va + vb + vc);
  return sum_of(t[0], sum_of(scaled(ab, vb * scale), scaled(ac, vc * scale)));
}

/// Keeps the wider gap of a direction of any length.
template <class WidthOf>
void keep_wider(Gap& best, const Point& direction, const WidthOf& width_of) {
  const double square = dot(direction, direction);
  if (!(square > 0x1p-900)) return;
  const Point unit = scaled(direction, 1 / std::sqrt(square));
  const double forward = width_of(unit), backward = width_of(scaled(unit, -1));
  if (forward > best.width) best = {unit, forward};
  if (backward > best.width) best = {scaled(unit, -1), backward};
}

/// The signed volume of a tetrahedron, 0 if its sign is not certain. Entries of the determinant are at most D, and off
/// by at most 2 error + u D. Six products of three change by less than 19 D^2 of that, and round by less than 64 u D^3.
double sure_volume(const Point& a, const Point& b, const Point& c, const Point& d, double error) {
  const Point x = difference(b, a), y = difference(c, a), z = difference(d, a);
  double size = 0;
  for (const Point& v : {x, y, z})
    for (const double entry : v) size = std::max(size, std::fabs(entry));
  const double volume = dot(x, cross_of(y, z));
  const double bound = 128 * size * size * (error + 0x1p-50 * size) + 0x1p-1000;
  return std::fabs(volume) > bound ? volume : 0;
}

/// The sides of a plane on which the corners of a triangle surely are: 1, -1, or 0.
std::array<int, 3> sure_sides(const Triangle& plane, const Triangle& t, double error) {
  std::array<int, 3> sides{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double volume = sure_volume(plane[0], plane[1], plane[2], t[i], error);
    sides[i] = volume > 0 ? 1 : volume < 0 ? -1 : 0;
  }
  return sides;
}

/// True if the line through p and q surely passes through the triangle.
bool surely_passes(const Point& p, const Point& q, const Triangle& t, double error) {
  const double x = sure_volume(p, q, t[0], t[1], error);
  const double y = x != 0 ? sure_volume(p, q, t[1], t[2], error) : 0;
  if (!((x > 0 && y > 0) || (x < 0 && y < 0))) return false;
  const double z = sure_volume(p, q, t[2], t[0], error);
  return (x > 0 && z > 0) || (x < 0 && z < 0);
}

/// True if an edge of `a` surely passes through `b`. `sides`: of the corners of `a`.
bool has_edge_through(const Triangle& a, const std::array<int, 3>& sides, const Triangle& b, double error) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    if (sides[i] * sides[next] < 0 && surely_passes(a[i], a[next], b, error)) return true;
  }
  return false;
}

bool are_on_one_side(const std::array<int, 3>& sides) {
  return sides[0] != 0 && sides[0] == sides[1] && sides[1] == sides[2];
}

}  // namespace

Gap gap_of(const MiddleBox& a, const RoundedTransform& at_a, const MiddleBox& b, const RoundedTransform& at_b) {
  const Point way = difference(at_b.of(b.middle), at_a.of(a.middle));
  std::array<Point, 3> of_a, of_b;
  for (std::size_t k = 0; k < 3; ++k) of_a[k] = column(at_a, k), of_b[k] = column(at_b, k);
  // The entries of the rotation from b to a, and both directions' extents.
  std::array<std::array<double, 3>, 3> r, abs_r;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) r[i][k] = dot(of_a[i], of_b[k]), abs_r[i][k] = std::fabs(r[i][k]);
  Gap best{{1, 0, 0}, kNoGap};
  const auto keep = [&](const Point& axis, double along, double width) {
    if (width > best.width) best = {along < 0 ? scaled(axis, -1) : axis, width};
  };
  std::array<double, 3> way_a, way_b;
  for (std::size_t i = 0; i < 3; ++i) {
    way_a[i] = dot(way, of_a[i]);
    way_b[i] = dot(way, of_b[i]);
    keep(of_a[i], way_a[i],
         std::fabs(way_a[i]) - a.half[i] -
             (b.half[0] * abs_r[i][0] + b.half[1] * abs_r[i][1] + b.half[2] * abs_r[i][2]));
    keep(of_b[i], way_b[i],
         std::fabs(way_b[i]) - b.half[i] -
             (a.half[0] * abs_r[0][i] + a.half[1] * abs_r[1][i] + a.half[2] * abs_r[2][i]));
  }
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const double square = 1 - r[i][k] * r[i][k];
      if (!(square > 0x1p-20)) continue;  // nearly parallel edges
      const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, k1 = (k + 1) % 3, k2 = (k + 2) % 3;
      const double along = way_a[i2] * r[i1][k] - way_a[i1] * r[i2][k];
      const double extent =
          a.half[i1] * abs_r[i2][k] + a.half[i2] * abs_r[i1][k] + b.half[k1] * abs_r[i][k2] + b.half[k2] * abs_r[i][k1];
      const double scale = 1 / std::sqrt(square), width = (std::fabs(along) - extent) * scale;
      if (width > best.width) {
        const Point axis = scaled(cross_of(of_a[i], of_b[k]), scale);
        best = {dot(axis, way) < 0 ? scaled(axis, -1) : axis, width};
      }
    }
  return best;
}

double width_along(const Point& direction, const Triangle& a, const Triangle& b) {
  return std::min({dot(direction, b[0]), dot(direction, b[1]), dot(direction, b[2])}) -
         std::max({dot(direction, a[0]), dot(direction, a[1]), dot(direction, a[2])});
}

Gap gap_of(const Triangle& a, const Triangle& b) {
  const auto width_of = [&](const Point& direction) { return width_along(direction, a, b); };
  Gap best{{1, 0, 0}, kNoGap};
  Point on_a = scaled(sum_of(sum_of(a[0], a[1]), a[2]), 1. / 3), on_b = closest_on(b, on_a);
  constexpr int kProjections = 4;
  constexpr double kGoodPart = 0.9;  // of the distance, which no gap exceeds
  for (int i = 0; i < kProjections; ++i) {
    on_a = closest_on(a, on_b);
    if (i > 0) on_b = closest_on(b, on_a);
    const Point way = difference(on_b, on_a);
    keep_wider(best, way, width_of);
    if (best.width * best.width >= kGoodPart * kGoodPart * dot(way, way)) break;
  }
  if (best.width > 0) return best;
  std::array<Point, 3> sides_a, sides_b;
  for (std::size_t i = 0; i < 3; ++i) {
    sides_a[i] = difference(a[(i + 1) % 3], a[i]);
    sides_b[i] = difference(b[(i + 1) % 3], b[i]);
  }
  const Point normal_a = cross_of(sides_a[0], sides_a[1]), normal_b = cross_of(sides_b[0], sides_b[1]);
  keep_wider(best, normal_a, width_of);
  keep_wider(best, normal_b, width_of);
  for (std::size_t i = 0; i < 3; ++i) {
    keep_wider(best, cross_of(sides_a[i], normal_a), width_of);
    keep_wider(best, cross_of(sides_b[i], normal_b), width_of);
    for (std::size_t k = 0; k < 3; ++k) keep_wider(best, cross_of(sides_a[i], sides_b[k]), width_of);
  }
  return best;
}

bool surely_meet(const Triangle& a, const Triangle& b, double error) {
  const std::array<int, 3> of_a = sure_sides(b, a, error);
  if (are_on_one_side(of_a)) return false;
  const std::array<int, 3> of_b = sure_sides(a, b, error);
  if (are_on_one_side(of_b)) return false;
  return has_edge_through(a, of_a, b, error) || has_edge_through(b, of_b, a, error);
}

}  // namespace tamis

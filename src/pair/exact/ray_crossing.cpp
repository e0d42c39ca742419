#include "pair/exact/ray_crossing.hpp"

#include <algorithm>
#include <optional>

#include "numbers/assert.hpp"
#include "numbers/estimate.hpp"
#include "numbers/finite.hpp"
#include "numbers/integer.hpp"
#include "numbers/vec.hpp"
#include "pair/exact/moving_polygon.hpp"
#include "pair/exact/nearest_point.hpp"
#include "pair/exact/units.hpp"

namespace tamis {
namespace {

/// False only if the ray surely misses the box of the face.
bool may_cross(const Point& origin, const std::array<Point, 3>& face) {
  const auto [a, b, c] = face;
  if (std::max({a[0], b[0], c[0]}) < origin[0]) return false;
  for (std::size_t k = 1; k < 3; ++k)
    if (std::min({a[k], b[k], c[k]}) > origin[k] || std::max({a[k], b[k], c[k]}) < origin[k]) return false;
  return true;
}

/// On which side of the line from a to b, seen along x, the moved origin lies, where the origin itself lies on it.
int side_of_moved(const Point& a, const Point& b) {
  if (a[2] != b[2]) return a[2] > b[2] ? 1 : -1;
  return a[1] == b[1] ? 0 : b[1] > a[1] ? 1 : -1;
}

/// ray_crossing(), or nothing if a sign is not certain. Coordinates count in units of their own axes. No sign depends
/// on these.
template <class Number>
std::optional<int> sure_crossing(const Point& origin, const std::array<Point, 3>& face, const Exponents& units) {
  const auto scaled = [&](const Point& p) {
    return Vec3<Number>{scaled_to_integer<Number>(p[0], units[0]), scaled_to_integer<Number>(p[1], units[1]),
                        scaled_to_integer<Number>(p[2], units[2])};
  };
  const Vec3<Number> from = scaled(origin);
  const std::array<Vec3<Number>, 3> corners{scaled(face[0]) - from, scaled(face[1]) - from, scaled(face[2]) - from};
  Number volume(0);
  int winding = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const Number area = corners[i].y * corners[j].z - corners[i].z * corners[j].y;
    if (!has_sign(area)) return {};
    const int side = area.sign() != 0 ? area.sign() : side_of_moved(face[i], face[j]);
    if (side == 0 || (i > 0 && side != winding)) return 0;
    winding = side;
    volume = volume + corners[k].x * area;
  }
  if (!has_sign(volume)) return {};
  return volume.sign() * winding > 0 ? winding : 0;
}

}  // namespace

int ray_crossing(const Point& origin, const std::array<Point, 3>& face) {
  TAMIS_ASSERT(is_finite(origin) && std::ranges::all_of(face, [](const Point& p) { return is_finite(p); }));
  if (!may_cross(origin, face)) return 0;
  Exponents units = lowest_exponents(face, lowest_exponents({&origin, 1}));
  for (int& unit : units)
    if (unit == INT_MAX) unit = 0;
  const std::optional<int> estimated = sure_crossing<Estimate>(origin, face, units);
  return estimated ? *estimated : *sure_crossing<Integer>(origin, face, units);
}

}  // namespace tamis

#include "oracle/winding.hpp"

#include <array>
#include <optional>
#include <random>

#include "oracle/exact_numbers.hpp"

namespace tamis::oracle {
namespace {

using Arrow = std::array<Rational, 3>;

Arrow difference(const Point& a, const Point& b) {
  return {Rational(a[0]) - Rational(b[0]), Rational(a[1]) - Rational(b[1]), Rational(a[2]) - Rational(b[2])};
}
Arrow rational_cross(const Arrow& a, const Arrow& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational rational_dot(const Arrow& a, const Arrow& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// 1 or -1 if the ray passes through the inside of the face, 0 if it misses, nothing if it meets an edge or lies in the
/// face's plane. A ray from another point of that plane misses the face.
std::optional<int> crossing(const Arrow& direction, const std::array<Arrow, 3>& corners) {
  std::array<Rational, 3> sides;
  for (std::size_t i = 0; i < 3; ++i)
    sides[i] = rational_dot(direction, rational_cross(corners[i], corners[(i + 1) % 3]));
  const Rational climb = sides[0] + sides[1] + sides[2],
                 volume = rational_dot(corners[0], rational_cross(corners[1], corners[2]));
  if (climb.sign() == 0) return {};
  if (volume.sign() == 0) return 0;
  for (const Rational& side : sides)
    if (side.sign() == 0) return {};
  for (const Rational& side : sides)
    if (side.sign() != climb.sign()) return 0;
  return volume.sign() == climb.sign() ? climb.sign() : 0;
}

bool has_area(const std::array<Arrow, 3>& corners) {
  Arrow first, second;
  for (std::size_t k = 0; k < 3; ++k) {
    first[k] = corners[1][k] - corners[0][k];
    second[k] = corners[2][k] - corners[0][k];
  }
  const Arrow normal = rational_cross(first, second);
  return rational_dot(normal, normal).sign() != 0;
}

}  // namespace

Crossings crossings(const Point& origin, const std::vector<Point>& points, const std::vector<Face>& faces) {
  std::vector<std::array<Arrow, 3>> all;
  for (const Face& face : faces) {
    std::array<Arrow, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = difference(points[static_cast<std::size_t>(face[i])], origin);
    if (has_area(corners)) all.push_back(corners);
  }
  std::mt19937 random(7);
  std::uniform_int_distribution<int> number(-100000, 100000);
  for (;;) {
    const Arrow direction{Rational(number(random)), Rational(number(random)), Rational(number(random))};
    Crossings sum;
    bool is_sure = true;
    for (const auto& corners : all) {
      const std::optional<int> one = crossing(direction, corners);
      is_sure = is_sure && one;
      if (!is_sure) break;
      sum.winding += *one;
      sum.count += *one != 0 ? 1 : 0;
    }
    if (is_sure) return sum;
  }
}

}  // namespace tamis::oracle

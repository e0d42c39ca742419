// Arithmetic of points and vectors.
#pragma once
#include <array>
#include <cmath>

#include "tamis/positions.hpp"

namespace tamis::adapters {

inline Point plus(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Point times(double factor, const Point& v) { return {factor * v[0], factor * v[1], factor * v[2]}; }
inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Point& v) { return std::hypot(v[0], v[1], v[2]); }

/// A matrix by its rows.
using Matrix = std::array<Point, 3>;
inline Point times(const Matrix& m, const Point& v) { return {dot(m[0], v), dot(m[1], v), dot(m[2], v)}; }
/// The product of the transposed matrix and v.
inline Point times_transposed(const Matrix& m, const Point& v) {
  return plus(plus(times(v[0], m[0]), times(v[1], m[1])), times(v[2], m[2]));
}

/// The matrix of a rotation vector.
inline Matrix rotation_matrix(const Point& rotation) {
  const double angle = length(rotation);
  if (!(angle > 0)) return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const auto [x, y, z] = times(1 / angle, rotation);
  const double s = std::sin(angle), c = std::cos(angle), d = 1 - c;
  return {{{c + d * x * x, d * x * y - s * z, d * x * z + s * y},
           {d * x * y + s * z, c + d * y * y, d * y * z - s * x},
           {d * x * z - s * y, d * y * z + s * x, c + d * z * z}}};
}

}  // namespace tamis::adapters

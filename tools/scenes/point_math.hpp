// Arithmetic on points, all of it rounded correctly by IEEE 754: a scene made of it has the same bits on every machine.
// Machines, bolts, reduced sheets and simulated setups use sine and cosine, too, and may differ in last places.
#pragma once
#include <cmath>
#include <vector>

#include "tamis/step.hpp"

namespace tamis::scenes {

inline Point operator+(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Point operator*(double s, const Point& a) { return {s * a[0], s * a[1], s * a[2]}; }

inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Point unit(const Point& a) { return (1 / std::sqrt(dot(a, a))) * a; }

/// The cube root of x >= 1, within some units in the last place, and exact for cubes of whole numbers; the cube roots
/// of libraries differ among machines.
inline double cube_root(double x) {
  double root = x;
  for (double next = (2 * root + x / (root * root)) / 3; next < root; next = (2 * root + x / (root * root)) / 3)
    root = next;  // Newton's steps fall until rounding stops them
  const double whole = std::round(root);
  return whole * whole * whole == x ? whole : root;
}

/// Rotates `p` about the direction of `axis`; the angle is 2 atan |axis|.
inline Point rotated(const Point& p, const Point& axis) {
  const double norm = 1 + dot(axis, axis);
  return p + (2 / norm) * (cross(axis, p) + cross(axis, cross(axis, p)));
}

/// The points with the axes exchanged, x for y for z: as hard a question, and nothing that a detector remembers of
/// `points` fits it.
inline std::vector<Point> exchanged(std::vector<Point> points) {
  for (Point& p : points) p = {p[1], p[2], p[0]};
  return points;
}

}  // namespace tamis::scenes

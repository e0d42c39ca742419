#include "fuzz/moving_points.hpp"

#include <limits>

namespace tamis::fuzz {
namespace {

double take_coordinate(ByteSource& bytes) {
  const int choice = bytes.below(256);
  if (choice < 176) return choice % 11 - 5;
  if (choice < 224) return std::ldexp(bytes.take<std::int16_t>(), -(choice % 16));
  if (choice < 248) return std::ldexp(static_cast<double>(bytes.take<std::int64_t>()), -62);
  return bytes.raw_double();
}

Point take_any(ByteSource& bytes) {
  Point p;
  for (double& x : p) x = take_coordinate(bytes);
  return p;
}

const Point& take_earlier(ByteSource& bytes, const std::vector<Point>& points) {
  return points[static_cast<std::size_t>(bytes.below(static_cast<int>(points.size())))];
}

/// p + k/4 (q - p), rounded; overflow gives p.
Point take_between(ByteSource& bytes, const std::vector<Point>& points) {
  const Point& p = take_earlier(bytes, points);
  const Point& q = take_earlier(bytes, points);
  const double k = 0.25 * (bytes.below(16) - 6);
  Point result = p;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double x = p[axis] + k * (q[axis] - p[axis]);
    if (std::isfinite(x)) result[axis] = x;
  }
  return result;
}

Point take_beside(ByteSource& bytes, const std::vector<Point>& points) {
  Point p = take_earlier(bytes, points);
  double& x = p[static_cast<std::size_t>(bytes.below(3))];
  const double limit = std::numeric_limits<double>::max() * (bytes.below(2) == 0 ? 1 : -1);
  for (int steps = 1 + bytes.below(4); steps > 0; --steps) x = std::nextafter(x, limit);
  return p;
}

/// `earlier`: the points at the same time.
Point take_point(ByteSource& bytes, const std::vector<Point>& earlier) {
  const int choice = bytes.below(16);
  if (earlier.empty() || choice < 10) return take_any(bytes);
  if (choice < 12) return take_earlier(bytes, earlier);
  return choice < 15 ? take_between(bytes, earlier) : take_beside(bytes, earlier);
}

}  // namespace

MovingPoints take_points(ByteSource& bytes, std::size_t count) {
  MovingPoints points;
  for (std::size_t i = 0; i < count; ++i) points.start.push_back(take_point(bytes, points.start));
  const bool at_rest = bytes.below(32) == 31;
  for (std::size_t i = 0; i < count; ++i)
    points.end.push_back(at_rest || bytes.below(8) == 7 ? points.start[i] : take_point(bytes, points.end));
  return points;
}

void place(ByteSource& bytes, MovingPoints& points) {
  const int choice = bytes.below(8);
  if (choice < 5) return;
  const int exponent = choice == 7 ? bytes.take<std::int16_t>() % 1024 : bytes.take<std::int8_t>() / 2;
  const double offset = choice == 6 ? bytes.take<std::int32_t>() : 0;
  for (auto* ends : {&points.start, &points.end})
    for (Point& p : *ends)
      for (double& x : p) {
        const double moved = std::ldexp(x, exponent) + offset;
        if (std::isfinite(moved)) x = moved;
      }
}

}  // namespace tamis::fuzz

#include "api/truncate/truncated.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "support/yardstick/pairs.hpp"
#include "tamis/pair_distance.hpp"

namespace tamis::test {
namespace {

std::vector<Point> at_time(const std::vector<Point>& from, const std::vector<Point>& to, double t) {
  std::vector<Point> points = from;
  for (std::size_t v = 0; v < points.size(); ++v)
    for (std::size_t k = 0; k < 3; ++k) points[v][k] = (1 - t) * from[v][k] + t * to[v][k];
  return points;
}

/// The largest |coordinate| of a pair's vertices: the unit for the rounding of a distance.
double size_of(const std::vector<Point>& points, const PairVertices& vertices) {
  double size = 0;
  for (const Index v : vertices)
    if (v >= 0)
      for (const double x : points[static_cast<std::size_t>(v)]) size = std::max(size, std::fabs(x));
  return size;
}

}  // namespace

void expect_kept(const Scene& scene, const std::vector<Point>& to, double fraction, double separation) {
  std::vector<std::vector<Point>> ways;
  for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) ways.push_back(at_time(scene.start, to, t));
  yardstick::for_each_pair(scene.mesh(), {}, [&](PairKind kind, const PairVertices& v) {
    const double before = distance_of({kind, v}, scene.start).distance;
    const double rounding = 0x1p-48 * std::max(size_of(scene.start, v), size_of(to, v));
    const bool starts_apart = before > separation;
    const double kept = starts_apart ? separation + fraction * (before - separation) : before * (1 - 0x1p-20);
    for (const auto& way : ways)
      ASSERT_GE(distance_of({kind, v}, way).distance, kept - rounding)
          << name_of(kind) << ' ' << v[0] << ' ' << v[1] << ' ' << v[2] << ' ' << v[3] << ", at the start " << before;
  });
}

Scene two_falls(double above, double fall, const Point& place, double size) {
  Scene scene;
  const auto add = [&](double x, double y, double z, double down, Index group) {
    const Point at{place[0] + size * x, place[1] + size * y, place[2] + z};
    return scene.add_vertex(at, {at[0], at[1], at[2] - down}, group);
  };
  for (const double x : {0.0, 10.0}) {
    const Index v = add(x, 0, 0, 0, 0);
    add(x + 1, 0, 0, 0, 0);
    add(x, 1, 0, 0, 0);
    scene.faces.push_back({v, v + 1, v + 2});
    scene.loose_points.push_back(x == 0 ? add(x + 0.25, 0.25, above, fall, 1) : add(x + 0.25, 0.25, 0.9, 0.1, 1));
  }
  return scene;
}

std::vector<Point> as_floats(std::vector<Point> points) {
  for (Point& p : points)
    for (double& x : p) x = static_cast<float>(x);
  return points;
}

}  // namespace tamis::test

// What the tests of truncated steps share: a scene of two falls, and what every pair has to keep.
#pragma once

#include <vector>

#include "scenes/scene.hpp"

namespace tamis::test {

using scenes::Scene;

/// Of every pair of the scene, at five times of the straight way to `to`, by its distance alone.
void expect_kept(const Scene& scene, const std::vector<Point>& to, double fraction, double separation);

/// A point falls on a triangle from height `above`, by `fall`; ten aside another does, that ends before it.
Scene two_falls(double above, double fall, const Point& place = {0, 0, 0}, double size = 1);

std::vector<Point> as_floats(std::vector<Point> points);

}  // namespace tamis::test

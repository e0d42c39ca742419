// For the tests of truncated steps: a scene of two falls, and a check of the distance that every pair has to keep.
#pragma once

#include <vector>

#include "scenes/scene.hpp"

namespace tamis::test {

using scenes::Scene;

/// Checks the distance of every pair of the scene at five times of the straight way to `to`.
void expect_kept(const Scene& scene, const std::vector<Point>& to, double fraction, double separation);

/// A point falls by `fall` on a triangle, from height `above`. At a distance of ten, another point falls, and ends
/// above its triangle.
Scene two_falls(double above, double fall, const Point& place = {0, 0, 0}, double size = 1);

std::vector<Point> as_floats(std::vector<Point> points);

}  // namespace tamis::test

// Whether a ray crosses a triangle, decided exactly. The sum over a closed surface says whether a point is inside.
#pragma once
#include <array>

#include "tamis/contact.hpp"

namespace tamis {

/// The ray begins at the point moved by (0, e, e^2), for any e > 0 that is small enough, and goes along +x. So it meets
/// no edge and no vertex, and the sum over a closed surface is the same as for any other ray (Edelsbrunner and Muecke,
/// Simulation of simplicity, ACM TOG 9, 1990). Returns 1 or -1 if the ray crosses the triangle, by the triangle's
/// winding as seen along the ray, else 0. REQUIRES: finite coordinates. Not checked (exact): the point is not on the
/// triangle. There the answer means nothing.
int ray_crossing(const Point& origin, const std::array<Point, 3>& face);

}  // namespace tamis

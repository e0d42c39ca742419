// Exact algebra with a minimum separation s > 0: finds when the features first come within s of each other.
//
// The distance is the distance of the origin to a moving convex polygon (pair/exact/moving_polygon.hpp). Where it first
// falls to s, the nearest point is a corner, or lies inside a side or inside the polygon. Then one of these vanishes:
//   corner c         |c|^2 - s^2                        degree 2
//   side from x to y |x cross y|^2 - s^2 |y - x|^2      degree 4
//   plane            (c.n)^2 - s^2 n.n                  degree 6
// At a root, signs of polynomials of degree at most 4 tell whether the foot of the perpendicular lies on the feature.
// If it does, the distance is at most s then. So the first such root of all is the first time. Proof, and why a
// polynomial that is always zero may be skipped: docs/numerics/distances.md, "In integers".
#pragma once
#include "pair/exact/moving_polygon.hpp"
#include "pair/exact/touching_times.hpp"

namespace tamis {

/// Adds all times at which the pair may come within the separation, or leave it. REQUIRES: a finite separation > 0, the
/// one given to difference_polygon().
void add_times_within(const MovingPolygon& polygon, double separation, TouchingTimes& times);

}  // namespace tamis

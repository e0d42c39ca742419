// Surfaces that scenes are made of.
#pragma once
#include <numbers>
#include <vector>

#include "scenes/simulation/vectors.hpp"
#include "tamis/mesh.hpp"

namespace tamis::simulation {

inline constexpr double kPi = std::numbers::pi;

struct Surface {
  std::vector<Vec> points;
  std::vector<Face> faces;
};

/// A square in the plane z = 0 around the origin, of cells x cells quads with alternating diagonals.
Surface square(Index cells, double side);
/// A disc in the plane z = 0: ring k has 6 k points; 6 rings^2 triangles, all nearly equilateral.
Surface disc(Index rings, double radius);
/// Two discs sewn together at the rim, seen from outside counter-clockwise, the upper one first; `gap` apart.
Surface pillow(Index rings, double radius, double gap);
/// A cube of cells x cells quads a side, blown up to a ball around the origin.
Surface ball(Index cells, double radius);
/// A polyline in the plane y = 0 (x > 0) turned about the z axis; `closed` joins its ends (a torus).
Surface revolved(const std::vector<Vec>& profile, Index segments, bool closed);
/// A box around the origin, 12 triangles.
Surface box(const Vec& size);

/// The surface with each point replaced by `map(point)`.
template <class Map>
Surface mapped(Surface surface, Map map) {
  for (Vec& p : surface.points) p = map(p);
  return surface;
}

/// All surfaces as one.
Surface joined(const std::vector<Surface>& surfaces);

}  // namespace tamis::simulation

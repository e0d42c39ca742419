// A surface embedded in a lattice of tetrahedra: robust, whatever the surface looks like inside.
#pragma once
#include <array>
#include <vector>

#include "scenes/simulation/surface.hpp"

namespace tamis::simulation {

struct Lattice {
  std::vector<Vec> nodes;
  std::vector<std::array<Index, 4>> tetrahedra;
  /// The tetrahedron that each point of the surface lies in.
  std::vector<Index> tetrahedron_of_point;
};

/// Cubes, `cells` along the surface's longest side, that lie inside the surface or hold a point or a bit of it, each
/// cut into six tetrahedra. Inside: the generalized winding number (Jacobson et al. 2013) of the centre is above one
/// half, which no hole disturbs much.
Lattice make_lattice(const Surface& surface, Index cells);

/// How often the surface winds around a point; 1 inside a closed one seen counter-clockwise from outside.
double winding_number(const Surface& surface, const Vec& point);

}  // namespace tamis::simulation

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

/// The cubes, `cells` along the surface's longest side, that lie inside the surface or hold one of its points or face
/// centres, each cut into six tetrahedra. A cube lies inside if the generalized winding number (Jacobson et al. 2013)
/// of its centre is above one half; holes disturb this test little.
Lattice make_lattice(const Surface& surface, Index cells);

/// How often the surface winds around a point; 1 inside a closed one seen counter-clockwise from outside.
double winding_number(const Surface& surface, const Vec& point);

}  // namespace tamis::simulation

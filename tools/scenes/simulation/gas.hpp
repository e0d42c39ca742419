// The pressure inside a closed surface.
#pragma once
#include <vector>

#include "scenes/simulation/particles.hpp"
#include "tamis/mesh.hpp"

namespace tamis::simulation {

/// A closed surface, seen from outside counter-clockwise, filled at a given rate until it reaches its volume.
struct Gas {
  std::vector<Face> faces;
  double full_pressure;  ///< pascals above the outside, as long as the bag is far from full
  double full_volume;    ///< cubic metres at which the pressure has fallen to zero
  double rise_time;      ///< seconds until the inflator gives its full pressure

  /// Puts one third of each triangle's force on each corner; the forces on a closed surface add up to zero.
  void accelerate(Particles& particles, double time, double dt) const;
  double volume(const Points& position) const;
};

}  // namespace tamis::simulation

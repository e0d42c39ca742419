#include "scenes/simulation/gas.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace tamis::simulation {

double Gas::volume(const Points& position) const {
  double sum = 0;
  for (const Face& f : faces) sum += position.col(f[0]).dot(position.col(f[1]).cross(position.col(f[2])));
  return sum / 6;
}

void Gas::accelerate(Particles& particles, double time, double dt) const {
  const Points& x = particles.position;
  const double lack = 1 - volume(x) / full_volume;
  const double pressure = full_pressure * std::min(1.0, time / rise_time) * std::clamp(4 * lack, 0.0, 1.0);
  for (const Face& f : faces) {
    const Vec area = 0.5 * (x.col(f[1]) - x.col(f[0])).cross(x.col(f[2]) - x.col(f[0]));
    for (Index v : f) particles.velocity.col(v) += dt * particles.inverse_mass[v] * pressure / 3 * area;
  }
}

}  // namespace tamis::simulation

// Stretch: an edge keeps its length, a tether never gets longer.
#pragma once
#include "scenes/simulation/particles.hpp"

namespace tamis::simulation {

struct Distance {
  Index a, b;
  double length;             ///< at rest, metres
  double compliance;         ///< metres per newton
  bool may_shorten = false;  ///< a tether: cloth between its ends may fold
  double multiplier = 0;

  void reset() { multiplier = 0; }
  void project(Particles& particles, double dt) {
    const double wa = particles.inverse_mass[a], wb = particles.inverse_mass[b];
    const Vec between = particles.position.col(a) - particles.position.col(b);
    const double now = between.norm();
    if (now == 0 || (may_shorten && now <= length)) return;
    const double change = multiplier_step(now - length, multiplier, compliance, wa + wb, dt);
    multiplier += change;
    particles.position.col(a) += wa * change / now * between;
    particles.position.col(b) -= wb * change / now * between;
  }
};

}  // namespace tamis::simulation

// The particles that constraints move: positions, velocities and inverse masses.
#pragma once
#include "scenes/simulation/vectors.hpp"

namespace tamis::simulation {

struct Particles {
  Points position;               ///< metres
  Points velocity;               ///< metres per second
  Eigen::VectorXd inverse_mass;  ///< 1/kg; 0: the particle is moved by its obstacle, or not at all

  Index count() const { return static_cast<Index>(position.cols()); }
};

/// Adds `mass` to the mass of a particle. A new particle has no mass yet: inverse mass 0.
inline void add_mass(double& inverse_mass, double mass) {
  inverse_mass = inverse_mass > 0 ? 1 / (1 / inverse_mass + mass) : 1 / mass;
}

/// The update common to all constraints of XPBD (Macklin, Mueller, Chentanez 2016, equation 18).
/// `compliance`: inverse stiffness; `weight`: sum of inverse masses times squared gradients; `dt`: seconds.
inline double multiplier_step(double value, double multiplier, double compliance, double weight, double dt) {
  const double softness = compliance / (dt * dt);
  return weight + softness > 0 ? -(value + softness * multiplier) / (weight + softness) : 0;
}

}  // namespace tamis::simulation

// An elastic solid: tetrahedra that resist strain and change of volume, and recover even when turned inside out.
#pragma once
#include <Eigen/Geometry>
#include <array>

#include "scenes/simulation/particles.hpp"

namespace tamis::simulation {

/// Lame parameters, in pascals.
struct Elasticity {
  double shear;
  double volume;
};

/// The fixed corotated material (Stomakhin et al. 2012): shear |F - R|^2 + volume / 2 (det F - 1)^2 per unit of volume,
/// each term one constraint. Both vanish at rest, so an unfinished solution does not swell or shrink the body, as it
/// does with neo-Hookean constraints, whose forces balance only once they have converged.
class Tetrahedron {
 public:
  Tetrahedron(const std::array<Index, 4>& vertices, const Points& rest, const Elasticity& elasticity);

  void reset() { shear_multiplier_ = volume_multiplier_ = 0; }
  void project(Particles& particles, double dt);

  double rest_volume() const { return rest_volume_; }

 private:
  Eigen::Matrix3d deformation(const Particles& particles) const;
  /// `slope`: derivative of the constraint with respect to the deformation.
  void apply(Particles& particles, const Eigen::Matrix3d& slope, double value, double compliance, double& multiplier,
             double dt) const;

  std::array<Index, 4> vertices_;
  Eigen::Matrix3d inverse_rest_;
  double rest_volume_;
  double shear_compliance_, volume_compliance_;
  Eigen::Quaterniond rotation_ = Eigen::Quaterniond::Identity();  ///< of the last deformation: a start for the next
  double shear_multiplier_ = 0, volume_multiplier_ = 0;
};

}  // namespace tamis::simulation

// An elastic solid: stable neo-Hookean tetrahedra, which recover even when turned inside out.
#pragma once
#include <array>

#include "scenes/simulation/particles.hpp"

namespace tamis::simulation {

/// Lame parameters, in pascals.
struct Elasticity {
  double shear;
  double volume;
};

/// Macklin and Mueller 2021, "A Constraint-based Formulation of Stable Neo-Hookean Materials".
class Tetrahedron {
 public:
  Tetrahedron(const std::array<Index, 4>& vertices, const Points& rest, const Elasticity& elasticity);

  void reset() { shear_multiplier_ = volume_multiplier_ = 0; }
  void project(Particles& particles, double dt);

  const std::array<Index, 4>& vertices() const { return vertices_; }
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
  double rest_determinant_;  ///< above 1: balances the shear constraint, whose own minimum is a point
  double shear_multiplier_ = 0, volume_multiplier_ = 0;
};

}  // namespace tamis::simulation

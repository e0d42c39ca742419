// A weighted sum of points that stays zero: isometric bending, and points embedded in a tetrahedron.
#pragma once
#include <array>

#include "scenes/simulation/particles.hpp"

namespace tamis::simulation {

template <std::size_t Count>
struct Linear {
  std::array<Index, Count> vertices;
  std::array<double, Count> coefficients;
  double compliance;
  Vec multiplier = Vec::Zero();

  void reset() { multiplier.setZero(); }
  void project(Particles& particles, double dt) {
    Vec value = Vec::Zero();
    double weight = 0;
    for (std::size_t i = 0; i < Count; ++i) {
      value += coefficients[i] * particles.position.col(vertices[i]);
      weight += coefficients[i] * coefficients[i] * particles.inverse_mass[vertices[i]];
    }
    Vec change;
    for (int axis = 0; axis < 3; ++axis)
      change[axis] = multiplier_step(value[axis], multiplier[axis], compliance, weight, dt);
    multiplier += change;
    for (std::size_t i = 0; i < Count; ++i)
      particles.position.col(vertices[i]) += particles.inverse_mass[vertices[i]] * coefficients[i] * change;
  }
};

using Bend = Linear<4>;        ///< the two triangles at an edge, flat at rest
using Attachment = Linear<5>;  ///< a point and the corners of its tetrahedron

/// The quadratic energy of Bergou et al. 2006, "A Quadratic Bending Model for Inextensible Surfaces": zero for any
/// rigid motion of the flat hinge. Edge x0 x1, opposite corners x2, x3; stiffness in newton metres.
Bend make_bend(const std::array<Index, 4>& vertices, const Points& rest, double stiffness);

/// Point `vertices[0]` at rest in the tetrahedron of the other four.
Attachment make_attachment(const std::array<Index, 5>& vertices, const Points& rest);

}  // namespace tamis::simulation

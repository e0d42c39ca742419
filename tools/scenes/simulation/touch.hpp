// A contact that Tamis reports, as a constraint: two features keep their distance, and rub.
#pragma once
#include <vector>

#include "scenes/simulation/particles.hpp"
#include "tamis/contact.hpp"

namespace tamis::simulation {

struct Touch {
  std::array<Index, 4> vertices;
  Eigen::Vector4d weights;  ///< points * weights: from the second feature's point of contact to that of the first
  Vec normal;               ///< the contact's normal: along this gap when the features come near
  double gap;               ///< to be kept along the normal at the end of the step, metres
};

/// `thickness`: the gap wanted, metres. Features closer than that are moved apart little by little, so that the
/// push adds no speed worth mentioning. REQUIRES: vertex and face, or two edges.
Touch make_touch(const Contact& contact, const Points& start, double thickness);

/// Moves the features apart; sliding during the step is held back in proportion to the push (Coulomb).
void project(const Touch& touch, Particles& particles, const Points& start, double friction);

}  // namespace tamis::simulation

// A contact that Tamis reports, as a constraint: two features keep their distance, and rub.
#pragma once
#include <vector>

#include "scenes/simulation/particles.hpp"
#include "tamis/contact.hpp"

namespace tamis::simulation {

struct Touch {
  std::array<Index, 4> vertices;
  Eigen::Vector4d weights;  ///< points * weights: from the closest point of the second feature to that of the first
  Vec normal;               ///< unit, along that gap while the features are still apart
  double gap;               ///< to be kept along the normal at the end of the step, metres
};

/// The pair as it stands shortly before it touches: there the gap has a direction, and the right side.
/// `thickness`: the gap wanted, metres. Features closer than that are moved apart little by little, so that the
/// push adds no speed worth mentioning.
Touch make_touch(const Contact& contact, const Points& start, const Points& end, double thickness);

/// Moves the features apart; sliding during the step is held back in proportion to the push (Coulomb).
void project(const Touch& touch, Particles& particles, const Points& start, double friction);

}  // namespace tamis::simulation

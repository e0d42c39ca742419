// Points of a simulation: one column a vertex, which is also what tamis::Positions views.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "tamis/step.hpp"

namespace tamis::simulation {

using Vec = Eigen::Vector3d;
using Points = Eigen::Matrix3Xd;

inline Points as_points(const std::vector<Vec>& list) {
  Points points(3, static_cast<Eigen::Index>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i) points.col(static_cast<Eigen::Index>(i)) = list[i];
  return points;
}

}  // namespace tamis::simulation

// Points of a simulation: one column a vertex, which is also what tamis::Positions views.
#pragma once
#include <Eigen/Core>

#include "tamis/step.hpp"

namespace tamis::simulation {

using Vec = Eigen::Vector3d;
using Points = Eigen::Matrix3Xd;

inline Positions view(const Points& points) { return {points.data(), static_cast<Index>(points.cols())}; }
inline Step step_between(const Points& start, const Points& end) { return {view(start), view(end)}; }

}  // namespace tamis::simulation

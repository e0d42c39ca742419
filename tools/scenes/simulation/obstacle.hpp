// A rigid body on a path that the scene prescribes.
#pragma once
#include <Eigen/Geometry>
#include <functional>

#include "scenes/simulation/particles.hpp"

namespace tamis::simulation {

struct Obstacle {
  /// From where the body stands in the model to where it is at a time (seconds); the identity at time 0.
  using Path = std::function<Eigen::Isometry3d(double time)>;

  Index first;  ///< of its vertices
  Index count;
  Path path;

  /// What turns the body at `from` into the body at `to`.
  Eigen::Isometry3d motion(double from, double to) const { return path(to) * path(from).inverse(); }
};

inline Eigen::Isometry3d at_rest(double) { return Eigen::Isometry3d::Identity(); }

}  // namespace tamis::simulation

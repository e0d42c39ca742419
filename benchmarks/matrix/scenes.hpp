// The scenes of the matrix by their names: recorded ones, generated kinds in five sizes or in one.
#pragma once
#include <string>
#include <vector>

#include "scenes/scene.hpp"

namespace tamis::matrix {

struct SceneName {
  std::string name;
  double triangles;              ///< approximate
  double crowding;               ///< work for a unit of motion, relative to that of a folded cloth
  bool is_here;                  ///< false for recorded scenes whose data is missing
  bool parts_groups = false;     ///< bodies do not touch themselves
  bool is_of_two_sizes = false;  ///< the finer part lies within the shortest separation, in mean edges, of itself
};

/// All scenes, in an order that does not depend on which are here.
const std::vector<SceneName>& scene_names();

/// Throws InvalidOptions if there is no such scene, and the errors of reading a file.
scenes::Scene load_scene(const std::string& name);

}  // namespace tamis::matrix

// The scenes of the matrix by their names: recorded ones, generated kinds in five sizes or in one.
#pragma once
#include <string>
#include <vector>

#include "scenes/scene.hpp"

namespace tamis::matrix {

struct SceneName {
  std::string name;
  double triangles;              ///< about
  double crowding;               ///< how many times the work for a unit of motion is that of a folded cloth
  bool is_here;                  ///< recorded scenes: the data is
  bool parts_groups = false;     ///< bodies do not touch themselves
  bool is_of_two_sizes = false;  ///< all of the finer part is nearer than the shortest separation, of mean edges
};

/// All of them, in an order that does not depend on what is here.
const std::vector<SceneName>& scene_names();

/// Throws InvalidOptions where there is no such scene, and what reading throws.
scenes::Scene load_scene(const std::string& name);

}  // namespace tamis::matrix

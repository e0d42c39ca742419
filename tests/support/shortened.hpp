// The first part of a scene's step, as in a trial of a line search.
#pragma once
#include "scenes/scene.hpp"

namespace tamis::test {

/// The scene during the first `part` of its step: at rest for 0.
inline scenes::Scene shortened(scenes::Scene scene, double part) {
  for (std::size_t v = 0; v < scene.start.size(); ++v)
    for (std::size_t k = 0; k < 3; ++k)
      scene.end[v][k] = scene.start[v][k] + part * (scene.end[v][k] - scene.start[v][k]);
  return scene;
}

}  // namespace tamis::test

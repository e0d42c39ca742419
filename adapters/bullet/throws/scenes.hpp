// The throws that engines are asked to stop.
#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "adapters/bullet/throws/arena.hpp"

namespace tamis::bullet {

/// One throw of a scene, with its own arena.
struct Trial {
  const Arena* arena;
  Throw thrown;
  /// Is the body, at the end, where it can only be if it passed through?
  std::function<bool(const Flight&)> is_through;
};

/// Keeps the arenas of its trials.
struct Scene {
  std::vector<std::unique_ptr<Arena>> arenas;
  std::vector<Trial> trials;
};

/// A plate of 30 x 20 x 4 cm, at 20 to 120 m/s, turning at up to some 100 rad/s about any axis, against a wall of 2 x 2
/// m and 128 triangles; 30 steps of 1/60 s.
Scene spinning_plates(int count);
/// A rod of 2 m on an axle through its middle that turns at 180 rad/s, and a plate without thickness that stands in its
/// way, somewhere in the 3 rad it turns in 1/60 s. Bullet turns no body by more than pi/4 a step: four steps of 1/240
/// s.
Scene spinning_rods(int count);

}  // namespace tamis::bullet

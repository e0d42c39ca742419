// Throws that engines are to stop.
#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "integrations/bullet/throws/arena.hpp"

namespace tamis::bullet {

/// One throw of a scene, and its arena.
struct Trial {
  const Arena* arena;
  Throw thrown;
  /// Has the body passed through? True if its last place can be reached in no other way.
  std::function<bool(const Flight&)> is_through;
};

/// Throws, and the arenas that they use.
struct Scene {
  std::vector<std::unique_ptr<Arena>> arenas;
  std::vector<Trial> trials;
};

/// A plate of 30 x 20 x 4 cm, at 20 to 120 m/s, turning at up to some 100 rad/s about any axis, against a wall of 2 x 2
/// m and 128 triangles; 30 steps of 1/60 s.
Scene spinning_plates(int count);
/// A rod of 2 m, on an axle through its middle, that turns at 180 rad/s. A plate without thickness stands in its way,
/// somewhere in the 3 rad that it turns in 1/60 s. Four steps of 1/240 s, as Bullet turns no body by more than pi/4 a
/// step.
Scene spinning_rods(int count);

}  // namespace tamis::bullet

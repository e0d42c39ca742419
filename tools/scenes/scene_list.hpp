// Every scene by its name.
#pragma once
#include <cstdint>
#include <span>
#include <string_view>

#include "scenes/scene.hpp"

namespace tamis::scenes {

struct Recipe {
  std::string_view name;
  std::string_view description;
  /// True: contacts per triangle do not depend on the size, good for 10 thousand to 4 million triangles.
  /// False: meant for tests of up to some thousand triangles.
  bool scales;
  /// Makes about `triangles` triangles (at least a few, whatever is asked).
  Scene (*make)(Index triangles, std::uint64_t seed);
};

std::span<const Recipe> recipes();

/// Throws InvalidOptions, naming the choices, if there is no such scene or `triangles` is below 1.
Scene scene_by_name(std::string_view name, Index triangles, std::uint64_t seed);

}  // namespace tamis::scenes

// Our own simulations of the four scenes of the paper's laboratory, since the original sequences are not available.
#pragma once
#include <cstdint>
#include <span>
#include <string_view>

#include "scenes/simulation/model.hpp"

namespace tamis::simulation {

/// About `triangles` triangles, obstacles included; `seed` decides how the cloth is creased at the start.
Model airbag(Index triangles, std::uint64_t seed);
Model cloth_ball(Index triangles, std::uint64_t seed);
Model funnel(Index triangles, std::uint64_t seed);
/// Throws Error, naming the Debian package, if the Stanford bunny is not installed.
Model bunny(Index triangles, std::uint64_t seed);

struct SimulatedScene {
  std::string_view name;
  std::string_view description;
  Index triangles;  ///< at full size
  int frames;
  Model (*make)(Index triangles, std::uint64_t seed);
};

std::span<const SimulatedScene> simulated_scenes();
/// Throws InvalidOptions, naming the choices, if there is no such scene.
const SimulatedScene& simulated_scene(std::string_view name);

}  // namespace tamis::simulation

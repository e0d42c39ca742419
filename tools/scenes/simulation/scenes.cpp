#include "scenes/simulation/scenes.hpp"

#include <array>
#include <string>

#include "tamis/error.hpp"

namespace tamis::simulation {
namespace {

constexpr std::array kScenes{
    SimulatedScene{"airbag", "a folded bag inflating against a steering wheel", 18'000, 80, airbag},
    SimulatedScene{"cloth-ball", "cloth drops over a ball that turns and wraps it", 92'000, 94, cloth_ball},
    SimulatedScene{"funnel", "cloth pressed through a funnel by a ball", 18'000, 100, funnel},
    SimulatedScene{"bunny", "an elastic bunny crushed by a plate", 4'000, 90, bunny},
};

}  // namespace

std::span<const SimulatedScene> simulated_scenes() { return kScenes; }

const SimulatedScene& simulated_scene(std::string_view name) {
  std::string names;
  for (const SimulatedScene& scene : kScenes) {
    if (scene.name == name) return scene;
    names += (names.empty() ? "" : ", ") + std::string(scene.name);
  }
  throw InvalidOptions("there is no simulated scene '" + std::string(name) + "': choose one of " + names);
}

}  // namespace tamis::simulation

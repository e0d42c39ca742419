// The scenes of the example simulator, frame by frame into a folder.
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <optional>

#include "python/src/bindings.hpp"
#include "python/src/signals.hpp"
#include "scenes/simulation/recording.hpp"
#include "tamis/error.hpp"

namespace tamis::python {
namespace {

namespace nb = nanobind;

/// Ctrl-C ends it after a frame; the same call goes on from there. Returns the number of the last frame.
int simulate(const std::string& name, const std::filesystem::path& folder, std::optional<Index> triangles,
             std::optional<int> frames, std::uint64_t seed) {
  const simulation::SimulatedScene& scene = simulation::simulated_scene(name);
  const int last = frames.value_or(scene.frames);
  Signals signals;
  signals.begin();
  try {
    const nb::gil_scoped_release unlocked;
    simulation::record(scene, {folder, last, triangles.value_or(scene.triangles), seed},
                       [&](const simulation::Simulator&) {
                         if (signals.ask()) throw Cancelled("the simulation was interrupted");
                       });
  } catch (const Cancelled&) {
    signals.rethrow();
    throw;
  }
  return last;
}

nb::dict simulated_scenes() {
  nb::dict names;
  for (const simulation::SimulatedScene& scene : simulation::simulated_scenes())
    names[nb::str(scene.name.data(), scene.name.size())] = nb::str(scene.description.data(), scene.description.size());
  return names;
}

}  // namespace

void bind_simulation(nb::module_& module) {
  const nb::arg any;
  const auto or_none = nb::arg().none();
  module.def("simulate", &simulate, any, any, or_none, or_none, any);
  module.def("frame_path", &simulation::frame_path);
  module.def("simulated_scenes", &simulated_scenes);
}

}  // namespace tamis::python

// The scenes that the project makes itself: of one step, or simulated frame by frame into a folder.
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>

#include <optional>

#include "numbers/floating_point_state.hpp"
#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"
#include "python/src/signals.hpp"
#include "scenes/scene_list.hpp"
#include "scenes/simulation/recording.hpp"
#include "tamis/error.hpp"

namespace tamis::python {
namespace {

nb::tuple scene(const std::string& name, Index triangles, std::uint64_t seed) {
  scenes::Scene made;
  {
    const nb::gil_scoped_release unlocked;
    made = scenes::scene_by_name(name, triangles, seed);
  }
  return nb::make_tuple(own<double>(std::move(made.start)), own<double>(std::move(made.end)),
                        own<Index>(std::move(made.faces)), own<Index>(std::move(made.loose_edges)),
                        own<Index>(std::move(made.loose_points)), own<Index>(std::move(made.group_of_vertex)));
}

/// Ctrl-C ends it after a frame; the same call goes on from there. Returns the number of the last frame.
int simulate(const std::string& name, const std::filesystem::path& folder, std::optional<Index> triangles,
             std::optional<int> frames, std::uint64_t seed) {
  const simulation::SimulatedScene& scene = simulation::simulated_scene(name);
  const int last = frames.value_or(scene.frames);
  Signals signals;
  signals.during([&] {
    simulation::record(scene, {folder, last, triangles.value_or(scene.triangles), seed},
                       [&](const simulation::Simulator&) {
                         if (signals.ask()) throw Cancelled("the simulation was interrupted");
                       });
  });
  return last;
}

/// What each scene shows, by its name.
template <class Scenes>
nb::dict descriptions(const Scenes& scenes) {
  nb::dict shown;
  for (const auto& scene : scenes) shown[nb::cast(scene.name)] = nb::cast(scene.description);
  return shown;
}

}  // namespace

void bind_scenes(nb::module_& module) {
  const nb::arg any;
  const auto or_none = nb::arg().none();
  using ToNearest = nb::call_guard<ComputingState>;
  module.def("scene", &scene, ToNearest());
  module.def("scene_names", [] { return descriptions(scenes::recipes()); });
  module.def("simulate", &simulate, any, any, or_none, or_none, any, ToNearest());
  module.def("frame_path", &simulation::frame_path);
  module.def("simulated_scenes", [] { return descriptions(simulation::simulated_scenes()); });
}

}  // namespace tamis::python

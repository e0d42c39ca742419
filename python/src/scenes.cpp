// The scenes that the project makes itself.
#include <nanobind/stl/string.h>

#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"
#include "scenes/scene_list.hpp"

namespace tamis::python {
namespace {

nb::tuple scene(const std::string& name, Index triangles, std::uint64_t seed) {
  scenes::Scene made;
  {
    const nb::gil_scoped_release unlocked;
    made = scenes::scene_by_name(name, triangles, seed);
  }
  return nb::make_tuple(own<double>(std::move(made.start), 3), own<double>(std::move(made.end), 3),
                        own<Index>(std::move(made.faces), 3), own<Index>(std::move(made.loose_edges), 2),
                        own<Index>(std::move(made.loose_points), 0), own<Index>(std::move(made.group_of_vertex), 0));
}

nb::dict scene_names() {
  nb::dict names;
  for (const scenes::Recipe& recipe : scenes::recipes())
    names[nb::str(recipe.name.data(), recipe.name.size())] =
        nb::str(recipe.description.data(), recipe.description.size());
  return names;
}

}  // namespace

void bind_scenes(nb::module_& module) {
  module.def("scene", &scene);
  module.def("scene_names", &scene_names);
}

}  // namespace tamis::python

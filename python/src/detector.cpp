// The detector's questions.
#include <nanobind/stl/filesystem.h>

#include "python/src/bindings.hpp"
#include "python/src/collected.hpp"
#include "python/src/questions.hpp"

namespace tamis::python {

void bind_detector(nb::module_& module) {
  nb::class_<Questions>(module, "Detector", nb::type_slots(collected<Questions>), nb::is_weak_referenceable())
      .def(nb::init<const Mesh&, const Asking&>())
      .def("contacts", &Questions::contacts)
      .def("earliest", &Questions::earliest)
      .def("is_free", &Questions::is_free)
      .def("contacts", &Questions::contacts_on_path)
      .def("earliest", &Questions::earliest_on_path)
      .def("is_free", &Questions::is_free_on_path)
      .def("safe_step", &Questions::safe_step)
      .def("truncate", &Questions::truncate)
      .def("pairs_within", &Questions::pairs_within)
      .def("intersections", &Questions::intersections)
      .def("has_intersection", &Questions::has_intersection)
      .def("statistics", &Questions::statistics)
      .def("write", &Questions::write_step)
      .def("write", &Questions::write_path);
}

}  // namespace tamis::python

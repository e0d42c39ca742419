// The detector's questions.
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>

#include "python/src/bindings.hpp"
#include "python/src/collected.hpp"
#include "python/src/questions.hpp"

namespace tamis::python {

void bind_detector(nb::module_& module) {
  const nb::arg any;
  const auto or_none = nb::arg().none();
  nb::class_<Questions>(module, "Detector", nb::type_slots(collected<Questions>), nb::is_weak_referenceable())
      .def(nb::init<const Mesh&, const Asking&>())
      .def("contacts", &Questions::contacts, any, any, or_none)
      .def("earliest", &Questions::earliest, any, any, or_none)
      .def("is_free", &Questions::is_free, any, any, or_none)
      .def("contacts", &Questions::contacts_on_path, any, any, or_none)
      .def("earliest", &Questions::earliest_on_path, any, any, or_none)
      .def("is_free", &Questions::is_free_on_path, any, any, or_none)
      .def("keep_distance", &Questions::keep_distance, any, any, any, or_none)
      .def("truncate", &Questions::truncate, any, any, any, or_none, any)
      .def("near", &Questions::near)
      .def("intersections", &Questions::intersections)
      .def("has_intersection", &Questions::has_intersection)
      .def("statistics", &Questions::statistics)
      .def("write", &Questions::write_step, any, any, any, any, or_none)
      .def("write", &Questions::write_path, any, any, any, any, or_none);
}

}  // namespace tamis::python

// The detector's questions, and the layouts of their answers.
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>

#include <cstddef>

#include "python/src/bindings.hpp"
#include "python/src/collected.hpp"
#include "python/src/layout.hpp"
#include "python/src/questions.hpp"

namespace tamis::python {
namespace {

nb::dict contact_layout() {
  return Layout(sizeof(Contact))
      .field("kind", "u1", offsetof(Contact, kind))
      .field("certainty", "u1", offsetof(Contact, certainty))
      .field("vertices", "(4,)i4", offsetof(Contact, vertices))
      .field("toi_lower", "f8", offsetof(Contact, toi_lower))
      .field("toi_upper", "f8", offsetof(Contact, toi_upper))
      .field("u", "f8", offsetof(Contact, u))
      .field("v", "f8", offsetof(Contact, v))
      .field("normal", "(3,)f8", offsetof(Contact, normal))
      .dict();
}

nb::dict near_layout() {
  return Layout(sizeof(NearPair))
      .field("kind", "u1", offsetof(NearPair, kind))
      .field("corners", "u1", offsetof(NearPair, corners))
      .field("vertices", "(4,)i4", offsetof(NearPair, vertices))
      .field("distance", "f8", offsetof(NearPair, distance))
      .field("u", "f8", offsetof(NearPair, u))
      .field("v", "f8", offsetof(NearPair, v))
      .field("direction", "(3,)f8", offsetof(NearPair, direction))
      .dict();
}

nb::dict intersection_layout() {
  return Layout(sizeof(Intersection))
      .field("edge", "(2,)i4", offsetof(Intersection, edge))
      .field("face", "(3,)i4", offsetof(Intersection, face))
      .field("s_lower", "f8", offsetof(Intersection, s_lower))
      .field("s_upper", "f8", offsetof(Intersection, s_upper))
      .field("u", "f8", offsetof(Intersection, u))
      .field("v", "f8", offsetof(Intersection, v))
      .dict();
}

}  // namespace

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
      .def("vertex_steps", &Questions::vertex_steps, any, any, any, or_none)
      .def("truncate", &Questions::truncate, any, any, any, or_none)
      .def("near", &Questions::near)
      .def("intersections", &Questions::intersections)
      .def("has_intersection", &Questions::has_intersection)
      .def("statistics", &Questions::statistics)
      .def("write_step", &Questions::write_step, any, any, any, any, or_none);
  module.def("near_layout", &near_layout);
  module.def("intersection_layout", &intersection_layout);
  module.def("contact_layout", &contact_layout);
}

}  // namespace tamis::python

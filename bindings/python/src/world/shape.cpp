// A mesh with its points at rest, of which bodies are made.
#include <nanobind/stl/string.h>

#include <string>

#include "python/src/answers.hpp"
#include "python/src/bindings.hpp"
#include "tamis/world.hpp"

namespace tamis::python {
namespace {

void make_shape(Shape* shape, const Mesh& mesh, const PointRows& points, const std::string& isa) {
  const nb::gil_scoped_release unlocked;
  new (shape) Shape(mesh, copy_of<Point>(points), isa_from_name(isa));
}

}  // namespace

void bind_shape(nb::module_& module) {
  nb::class_<Shape>(module, "Shape")
      .def("__init__", &make_shape)
      .def("points", [](const Shape& shape) { return own<double>(std::vector<Point>(shape.points())); })
      .def("memory_bytes", &Shape::memory_bytes);
}

}  // namespace tamis::python

#include "python/src/audit/source.hpp"

#include <nanobind/stl/string.h>

namespace tamis::python {

audit::FramePointer IteratorSource::next() {
  const nb::gil_scoped_acquire lock;
  const nb::object item = nb::steal(PyIter_Next(iterator_.ptr()));
  if (!item.is_valid()) {
    if (PyErr_Occurred() != nullptr) throw nb::python_error();
    return nullptr;
  }
  auto frame = std::make_shared<audit::Frame>();
  const auto parts = nb::cast<nb::tuple>(item);
  frame->name = nb::cast<std::string>(parts[0]);
  if (!parts[1].is_none()) frame->positions = points_of(positions(nb::cast<Rows>(parts[1])));
  if (!parts[2].is_none()) frame->mesh = nb::cast<const SharedMesh&>(parts[2]).mesh;
  frame->problem = nb::cast<std::string>(parts[3]);
  frame->note = nb::cast<std::string>(parts[4]);
  return frame;
}

}  // namespace tamis::python

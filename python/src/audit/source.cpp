#include "python/src/audit/source.hpp"

#include <nanobind/stl/string.h>

namespace tamis::python {

std::vector<Point> points_of(const Rows& rows) {
  const Positions view = positions(rows);
  std::vector<Point> points;
  points.reserve(static_cast<std::size_t>(view.count()));
  for (Index v = 0; v < view.count(); ++v) points.push_back({view[v][0], view[v][1], view[v][2]});
  return points;
}

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
  if (!parts[1].is_none()) frame->positions = points_of(nb::cast<Rows>(parts[1]));
  if (!parts[2].is_none()) frame->mesh = nb::cast<const SharedMesh&>(parts[2]).mesh;
  frame->problem = nb::cast<std::string>(parts[3]);
  frame->note = nb::cast<std::string>(parts[4]);
  frame->follows = nb::cast<bool>(parts[5]);
  return frame;
}

}  // namespace tamis::python

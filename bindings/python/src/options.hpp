// Options with what belongs to Python in them.
#pragma once
#include "python/src/arrays.hpp"
#include "tamis/options.hpp"

namespace tamis::python {

struct Asking {
  Options options;
  nb::object accepts = nb::none();       ///< (kind, vertices) -> bool, or none
  nb::object is_cancelled = nb::none();  ///< () -> bool, or none

  int traverse(visitproc visit, void* arg) const {
    Py_VISIT(accepts.ptr());
    Py_VISIT(is_cancelled.ptr());
    return 0;
  }
  void clear() { accepts = is_cancelled = nb::none(); }
};

}  // namespace tamis::python

// Exceptions that only the module for Python throws.
#pragma once
#include "tamis/error.hpp"

namespace tamis::python {

/// A second question before the first has been answered.
struct Busy : Error {
  Busy() : Error("the detector is answering another question: give each thread a detector of its own") {}
};

}  // namespace tamis::python

// Truth values that the user's functions return.
#pragma once
#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include <string>

#include "tamis/error.hpp"

namespace tamis::python {

/// True or False, NumPy's too, as the user's function returned it. Throws InvalidOptions for any other object: a
/// function without `return` returns None. `function()` begins the sentence. Call with the interpreter's lock held.
template <class Function>
bool truth_of(const nanobind::object& answer, const Function& function) {
  bool is_true = false;
  if (nanobind::try_cast(answer, is_true)) return is_true;
  const std::string type = nanobind::cast<std::string>(answer.type().attr("__name__"));
  if (type == "bool_" || type == "bool") return nanobind::cast<bool>(nanobind::bool_(answer));
  throw InvalidOptions(std::string(function()) + " returned an object of the type " + type + ": return True or False");
}

}  // namespace tamis::python

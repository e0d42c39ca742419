// What a question cost, by names.
#pragma once
#include <nanobind/nanobind.h>

#include "tamis/statistics.hpp"

namespace tamis::python {

nanobind::dict as_dict(const Statistics& statistics);

}  // namespace tamis::python

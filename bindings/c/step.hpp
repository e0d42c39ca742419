// Converts positions and steps from C.
#pragma once
#include <algorithm>
#include <limits>
#include <string>

#include "c/failure.hpp"
#include "tamis/step.hpp"

namespace tamis::c {

inline Positions positions(const double* rows, Index count, std::ptrdiff_t stride, const char* name) {
  if (count < 0) throw InvalidStep("vertex_count is " + std::to_string(count) + ": give a number of rows, >= 0");
  if (stride != 0 && stride < 3)
    throw InvalidArgument(std::string(name) + "_stride is " + std::to_string(stride) +
                          ": give the doubles from one row to the next, at least 3, or 0");
  if (count > 0 && std::max<std::ptrdiff_t>(stride, 3) > std::numeric_limits<std::ptrdiff_t>::max() / 8 / count)
    throw InvalidArgument(std::string(name) + "_stride is " + std::to_string(stride) + ", and there are " +
                          std::to_string(count) +
                          " rows: no memory is so large; give the doubles from one to the next");
  return {count > 0 ? &required(rows, name) : rows, count, stride == 0 ? 3 : stride};
}

inline Step step_of(const tamis_step& given) {
  return {positions(given.start, given.vertex_count, given.start_stride, "start"),
          positions(given.end, given.vertex_count, given.end_stride, "end")};
}

}  // namespace tamis::c

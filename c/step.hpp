// Positions as C gives them.
#pragma once
#include "c/failure.hpp"
#include "tamis/step.hpp"

namespace tamis::c {

inline Positions positions(const double* rows, Index count, std::ptrdiff_t stride, const char* name) {
  if (stride != 0 && stride < 3)
    throw InvalidArgument(std::string(name) + "_stride is " + std::to_string(stride) +
                          ": give the doubles from one row to the next, at least 3, or 0");
  return {count > 0 ? &required(rows, name) : rows, count, stride == 0 ? 3 : stride};
}

inline Step step_of(const tamis_step& given) {
  return {positions(given.start, given.vertex_count, given.start_stride, "start"),
          positions(given.end, given.vertex_count, given.end_stride, "end")};
}

}  // namespace tamis::c

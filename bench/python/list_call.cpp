// The C++ call that tamis.vertex_face stands for, for overhead.py to call by ctypes.
#include <chrono>

#include "tamis/pair.hpp"

/// Seconds for `count` vertices against as many faces, four points a pair; results in memory of their own, as in
/// Python.
extern "C" __attribute__((visibility("default"))) double tamis_list_call(std::size_t count, const double* start,
                                                                         const double* end) {
  const auto points = [&](const double* rows) {
    return std::span(reinterpret_cast<const tamis::Point*>(rows), 4 * count);
  };
  const auto begin = std::chrono::steady_clock::now();
  std::vector<tamis::PairResult> results(count);
  tamis::narrow_phase(tamis::PairKind::vertex_face, points(start), points(end), results);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

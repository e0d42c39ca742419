// The C++ call behind tamis.narrow_phase; overhead.py calls it by ctypes.
#include <chrono>

#include "tamis/pair.hpp"

/// Seconds for `count` pairs of a vertex and a face, four points each. Allocates the results, as Python does.
extern "C" __attribute__((visibility("default"))) double tamis_list_call(std::size_t count, const double* start,
                                                                         const double* end) {
  std::vector<tamis::FeaturePair> pairs(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto first = static_cast<tamis::Index>(4 * i);
    pairs[i] = {tamis::PairKind::vertex_face, {first, first + 1, first + 2, first + 3}};
  }
  const auto points = static_cast<tamis::Index>(4 * count);
  const auto begin = std::chrono::steady_clock::now();
  const auto results = tamis::narrow_phase(pairs, {{start, points}, {end, points}});
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// Every vertex its own step.
#include <algorithm>
#include <string>

#include "c/detector.hpp"

using namespace tamis::c;

namespace {

tamis::Stored known_stored(int32_t stored) {
  if (stored != TAMIS_FLOAT64 && stored != TAMIS_FLOAT32)
    throw InvalidArgument("stored is " + std::to_string(stored) + ": give TAMIS_FLOAT64 or TAMIS_FLOAT32");
  return static_cast<tamis::Stored>(stored);
}

}  // namespace

tamis_status tamis_detector_truncate(tamis_detector* detector, const tamis_step* step, double keep, int32_t stored,
                                     double* positions, double* fractions, int* is_free) {
  return ask(detector, step, [&](tamis_detector& handle, const tamis::Step& s, const tamis::QueryOptions& q) {
    double& first = required(positions, "positions");
    int& free = required(is_free, "is_free");
    const tamis::TruncatedStep reached = handle.asked->truncate(s, keep, q, known_stored(stored));
    copy_points(reached.positions, &first);
    if (fractions) std::copy(reached.fractions.begin(), reached.fractions.end(), fractions);
    free = reached.is_free ? 1 : 0;
  });
}

// Every vertex its own step.
#include <algorithm>

#include "c/detector.hpp"

using namespace tamis::c;

tamis_status tamis_detector_truncate(tamis_detector* detector, const tamis_step* step, double fraction,
                                     double* positions, double* parts, int* is_free) {
  return ask(detector, step, [&](tamis_detector& handle, const tamis::Step& s, const tamis::QueryOptions& q) {
    double& first = required(positions, "positions");
    int& free = required(is_free, "is_free");
    const tamis::TruncatedStep reached = handle.detector->truncate(s, fraction, q);
    copy_points(reached.positions, &first);
    if (parts) std::copy(reached.parts.begin(), reached.parts.end(), parts);
    free = reached.is_free ? 1 : 0;
  });
}

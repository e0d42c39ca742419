// Every vertex its own step.
#include <algorithm>

#include "c/detector.hpp"

using namespace tamis::c;

tamis_status tamis_detector_vertex_steps(tamis_detector* detector, const tamis_step* step, double fraction,
                                         double* together, double* until) {
  return ask(detector, step, [&](tamis_detector& handle, const tamis::Step& s, Separation d) {
    double &common = required(together, "together"), &first = required(until, "until");
    const tamis::VertexSteps steps = handle.detector->vertex_steps(s, fraction, d);
    common = steps.together;
    std::copy(steps.until.begin(), steps.until.end(), &first);
  });
}

tamis_status tamis_detector_truncate(tamis_detector* detector, const tamis_step* step, double fraction,
                                     double* positions, int* is_free) {
  return ask(detector, step, [&](tamis_detector& handle, const tamis::Step& s, Separation d) {
    double& first = required(positions, "positions");
    int& free = required(is_free, "is_free");
    const tamis::TruncatedStep reached = handle.detector->truncate(s, fraction, d);
    copy_points(reached.positions, &first);
    free = reached.is_free ? 1 : 0;
  });
}

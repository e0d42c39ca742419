// Questions about a mesh in one pose.
#include "c/detector.hpp"

namespace tamis::c {
namespace {

/// The positions at the start of the step.
Positions start_of(const tamis_step* step) {
  const tamis_step given = read_sized(step, "step");
  return positions(given.start, given.vertex_count, given.start_stride, "start");
}

}  // namespace
}  // namespace tamis::c

using namespace tamis::c;

tamis_status tamis_detector_pairs_within(tamis_detector* detector, const tamis_step* step, double distance,
                                         size_t* count) {
  return with(detector, [&](tamis_detector& handle) {
    keep_rows(handle.near, count, [&] { return handle.object->pairs_within(start_of(step), distance); });
  });
}

tamis_status tamis_detector_intersections(tamis_detector* detector, const tamis_step* step, size_t* count) {
  return with(detector, [&](tamis_detector& handle) {
    keep_rows(handle.intersections, count, [&] { return handle.object->intersections(start_of(step)); });
  });
}

tamis_status tamis_detector_has_intersection(tamis_detector* detector, const tamis_step* step, int* has_intersection) {
  return with(detector, [&](tamis_detector& handle) {
    required(has_intersection, "has_intersection") = handle.object->has_intersection(start_of(step)) ? 1 : 0;
  });
}

tamis_status tamis_detector_copy_pairs_within(tamis_detector* detector, size_t first, size_t count,
                                              tamis_near_pair* pairs, size_t pair_size) {
  return copy_near(detector, {first, count, pairs, pair_size});
}

tamis_status tamis_detector_copy_intersections(tamis_detector* detector, size_t first, size_t count,
                                               tamis_intersection* intersections, size_t intersection_size) {
  return copy_intersections(detector, {first, count, intersections, intersection_size});
}

// Questions about a mesh at rest.
#include <algorithm>

#include "c/answers.hpp"
#include "c/detector.hpp"

namespace tamis::c {
namespace {

/// Runs `work(handle, positions)` with the start of the step.
template <class Work>
tamis_status ask_at_rest(tamis_detector* handle, const tamis_step* step, const Work& work) noexcept {
  return with(handle, [&](tamis_detector& h) {
    const tamis_step given = read_sized(step, "step");
    work(h, positions(given.start, given.vertex_count, given.start_stride, "start"));
  });
}

tamis_intersection intersection_of(const Intersection& i) {
  tamis_intersection result{{}, {}, i.s_lower, i.s_upper, i.u, i.v};
  std::copy(i.edge.begin(), i.edge.end(), result.edge);
  std::copy(i.face.begin(), i.face.end(), result.face);
  return result;
}

}  // namespace
}  // namespace tamis::c

using namespace tamis::c;

tamis_status tamis_detector_pairs_within(tamis_detector* detector, const tamis_step* step, double distance,
                                         size_t* count) {
  return ask_at_rest(detector, step, [&](tamis_detector& handle, const tamis::Positions& at) {
    size_t& number = required(count, "count");
    handle.near = handle.detector->pairs_within(at, distance);
    number = handle.near.size();
  });
}

tamis_status tamis_detector_intersections(tamis_detector* detector, const tamis_step* step, size_t* count) {
  return ask_at_rest(detector, step, [&](tamis_detector& handle, const tamis::Positions& at) {
    size_t& number = required(count, "count");
    handle.intersections = handle.detector->intersections(at);
    number = handle.intersections.size();
  });
}

tamis_status tamis_detector_has_intersection(tamis_detector* detector, const tamis_step* step, int* has_intersection) {
  return ask_at_rest(detector, step, [&](tamis_detector& handle, const tamis::Positions& at) {
    required(has_intersection, "has_intersection") = handle.detector->has_intersection(at) ? 1 : 0;
  });
}

tamis_status tamis_detector_copy_pairs_within(tamis_detector* detector, size_t first, size_t count,
                                              tamis_near_pair* pairs, size_t pair_size) {
  return with(detector, [&](tamis_detector& handle) {
    copy_rows(handle.near, near_pair_of, {first, count, pairs, pair_size}, "pairs");
  });
}

tamis_status tamis_detector_copy_intersections(tamis_detector* detector, size_t first, size_t count,
                                               tamis_intersection* intersections, size_t intersection_size) {
  return with(detector, [&](tamis_detector& handle) {
    copy_rows(handle.intersections, intersection_of, {first, count, intersections, intersection_size}, "intersections");
  });
}

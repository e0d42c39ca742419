// Questions to a world.
#include "c/motions.hpp"
#include "c/world.hpp"

namespace tamis::c {
namespace {

PoseOptions at_rest(int include_static) { return {.include_static = include_static != 0}; }

tamis_earliest earliest_of(const EarliestBodyContact& first) {
  tamis_earliest answer{first.toi_lower, first.toi_upper, first.contact ? 1 : 0, {}};
  if (first.contact) answer.contact = contact_of(*first.contact);
  return answer;
}

/// Runs `work(handle, world, options)`.
template <class Work>
tamis_status ask(tamis_world* handle, const tamis_path_options* options, const Work& work) noexcept {
  return with(handle, [&](tamis_world& h) {
    h.contacts.clear();
    work(h, *h.object, path_options_of(read_options(options)));
  });
}

}  // namespace
}  // namespace tamis::c

using namespace tamis::c;

tamis_status tamis_world_contacts(tamis_world* world, const tamis_path_options* options, size_t* count) {
  return ask(world, options, [&](tamis_world& handle, tamis::World& w, const tamis::PathOptions& q) {
    keep_rows(handle.contacts, count, [&] { return w.contacts(q); });
  });
}

tamis_status tamis_world_first_contacts(tamis_world* world, const tamis_path_options* options, size_t* count) {
  return ask(world, options, [&](tamis_world& handle, tamis::World& w, const tamis::PathOptions& q) {
    keep_rows(handle.contacts, count, [&] { return w.first_contacts(q); });
  });
}

tamis_status tamis_world_earliest(tamis_world* world, const tamis_path_options* options, double* toi_lower,
                                  double* toi_upper, size_t* count) {
  return ask(world, options, [&](tamis_world& handle, tamis::World& w, const tamis::PathOptions& q) {
    const FirstTimes times = first_times(toi_lower, toi_upper, count);
    times.write(handle, w.earliest(q));
  });
}

tamis_status tamis_world_earliest_many(tamis_world* world, const int32_t* bodies, size_t body_count,
                                       const tamis_motions* motions, const tamis_path_options* options,
                                       tamis_earliest* answers, size_t answer_size) {
  return ask(world, options, [&](tamis_world&, tamis::World& w, const tamis::PathOptions& q) {
    const tamis_motions given = read_sized(motions, "motions");
    const auto named = bodies_of(bodies, body_count, "body_count");
    check_size(answer_size, sizeof(int32_t), "answer");
    check_count(given.count, "count");
    if (given.count > 0) required(answers, "answers");
    const auto found = w.earliest_many(named, motions_of(given), q);
    for (std::size_t i = 0; i < found.size(); ++i) write_element(earliest_of(found[i]), answers, i, answer_size);
  });
}

tamis_status tamis_world_is_free(tamis_world* world, const tamis_path_options* options, int* is_free) {
  return ask(world, options, [&](tamis_world&, tamis::World& w, const tamis::PathOptions& q) {
    required(is_free, "is_free") = w.is_free(q) ? 1 : 0;
  });
}

tamis_status tamis_world_safe_step(tamis_world* world, double keep, const tamis_path_options* options,
                                   tamis_safe_step* answer) {
  return ask(world, options, [&](tamis_world&, tamis::World& w, const tamis::PathOptions& q) {
    write_sized(tamis_safe_step{}, answer, "answer");  // refuses a bad `answer` before the work
    write_sized(answer_of(w.safe_step(keep, q)), answer, "answer");
  });
}

tamis_status tamis_world_pairs_within(tamis_world* world, double distance, int include_static, size_t* count) {
  return with(world, [&](tamis_world& handle) {
    keep_rows(handle.near, count, [&] { return handle.object->pairs_within(distance, at_rest(include_static)); });
  });
}

tamis_status tamis_world_intersections(tamis_world* world, int include_static, size_t* count) {
  return with(world, [&](tamis_world& handle) {
    keep_rows(handle.intersections, count, [&] { return handle.object->intersections(at_rest(include_static)); });
  });
}

tamis_status tamis_world_has_intersection(tamis_world* world, int include_static, int* has_intersection) {
  return with(world, [&](tamis_world& handle) {
    required(has_intersection, "has_intersection") = handle.object->has_intersection(at_rest(include_static)) ? 1 : 0;
  });
}

tamis_status tamis_world_has_overlap(tamis_world* world, int include_static, int* has_overlap) {
  return with(world, [&](tamis_world& handle) {
    required(has_overlap, "has_overlap") = handle.object->has_overlap(at_rest(include_static)) ? 1 : 0;
  });
}

tamis_status tamis_world_is_closed(tamis_world* world, int32_t body, int* is_closed) {
  return with(world,
              [&](tamis_world& handle) { required(is_closed, "is_closed") = handle.object->is_closed(body) ? 1 : 0; });
}

tamis_status tamis_world_copy_contacts(tamis_world* world, size_t first, size_t count, tamis_contact* contacts,
                                       size_t contact_size) {
  return copy_contacts(world, {first, count, contacts, contact_size});
}

tamis_status tamis_world_copy_pairs_within(tamis_world* world, size_t first, size_t count, tamis_near_pair* pairs,
                                           size_t pair_size) {
  return copy_near(world, {first, count, pairs, pair_size});
}

tamis_status tamis_world_copy_intersections(tamis_world* world, size_t first, size_t count,
                                            tamis_intersection* intersections, size_t intersection_size) {
  return copy_intersections(world, {first, count, intersections, intersection_size});
}

tamis_status tamis_world_statistics(tamis_world* world, tamis_statistics* statistics) {
  return copy_statistics(world, statistics);
}

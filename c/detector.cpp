#include "c/detector.hpp"

#include <algorithm>
#include <string>

#include "c/answers.hpp"
#include "c/mesh.hpp"
#include "c/options.hpp"
#include "c/sized.hpp"

namespace tamis::c {
namespace {

tamis_contact contact_of(const Contact& c) {
  tamis_contact contact{
      static_cast<int32_t>(c.kind), static_cast<int32_t>(c.certainty), {}, c.toi_lower, c.toi_upper, c.u, c.v, {}};
  std::copy(c.vertices.begin(), c.vertices.end(), contact.vertices);
  std::copy(c.normal.begin(), c.normal.end(), contact.normal);
  return contact;
}

tamis_statistics statistics_of(const Statistics& s, std::vector<std::string>& names) {
  tamis_statistics answer{};
  answer.isa = name_of(s.isa).data();  // a literal
  answer.threads = s.threads;
  answer.rebuilt = s.rebuilt ? 1 : 0;
  answer.seconds_total = s.seconds.total;
  answer.seconds_bounds = s.seconds.bounds;
  answer.seconds_build = s.seconds.build;
  answer.seconds_traverse = s.seconds.traverse;
  answer.seconds_filter = s.seconds.filter;
  answer.seconds_solve = s.seconds.solve;
  answer.decided_by_lanes = s.decided_by.lanes;
  answer.decided_by_scalar = s.decided_by.scalar;
  answer.decided_by_exact = s.decided_by.exact;
  answer.unresolved = s.decided_by.unresolved;
  answer.nodes_visited = s.nodes_visited;
  answer.memory_bytes = s.memory_bytes;
  answer.ignored = s.ignored;
  const std::size_t count = std::min<std::size_t>(s.stages.size(), TAMIS_MOST_STAGES);
  answer.stage_count = static_cast<int32_t>(count);
  names.clear();
  for (std::size_t i = 0; i < count; ++i) names.emplace_back(s.stages[i].name);
  for (std::size_t i = 0; i < count; ++i)
    answer.stages[i] = {names[i].c_str(), s.stages[i].vf, s.stages[i].ee, s.stages[i].ve, s.stages[i].vv};
  return answer;
}

}  // namespace
}  // namespace tamis::c

using namespace tamis::c;

tamis_status tamis_detector_create(const tamis_mesh* mesh, const tamis_options* options, tamis_detector** detector) {
  return make_handle(detector, [&](tamis_detector& handle) {
    if (!required(mesh, "mesh").mesh)
      throw tamis::InvalidMesh("the mesh could not be made: " + std::string(mesh->outcome.message()));
    const auto given = options ? read_sized(options, "options") : tamis_options{};
    handle.detector.emplace(*mesh->mesh, options_of(given, mesh->mesh->vertex_count()));
  });
}

void tamis_detector_free(tamis_detector* detector) { delete detector; }

const char* tamis_detector_message(const tamis_detector* detector) {
  return detector ? detector->outcome.message() : "";
}

tamis_status tamis_detector_contacts(tamis_detector* detector, const tamis_step* step, size_t* count) {
  return ask(detector, step, [&](tamis_detector& handle, const tamis::Step& s, const tamis::QueryOptions& q) {
    size_t& number = required(count, "count");
    handle.detector->contacts(s, handle.contacts, q);
    number = handle.contacts.size();
  });
}

tamis_status tamis_detector_earliest(tamis_detector* detector, const tamis_step* step, double* toi_lower,
                                     double* toi_upper, size_t* count) {
  return ask(detector, step, [&](tamis_detector& handle, const tamis::Step& s, const tamis::QueryOptions& q) {
    const FirstTimes times = first_times(toi_lower, toi_upper, count);
    times.write(handle, handle.detector->earliest(s, q));
  });
}

tamis_status tamis_detector_is_free(tamis_detector* detector, const tamis_step* step, int* is_free) {
  return ask(detector, step, [&](tamis_detector& handle, const tamis::Step& s, const tamis::QueryOptions& q) {
    required(is_free, "is_free") = handle.detector->is_free(s, q) ? 1 : 0;
  });
}

tamis_status tamis_detector_safe_step(tamis_detector* detector, const tamis_step* step, double keep,
                                      tamis_safe_step* answer) {
  return ask(detector, step, [&](tamis_detector& handle, const tamis::Step& s, const tamis::QueryOptions& q) {
    write_sized(tamis_safe_step{}, answer, "answer");  // refused before the work
    write_sized(answer_of(handle.detector->safe_step(s, keep, q)), answer, "answer");
  });
}

tamis_status tamis_detector_copy_contacts(tamis_detector* detector, size_t first, size_t count, tamis_contact* contacts,
                                          size_t contact_size) {
  return with(detector, [&](tamis_detector& handle) {
    copy_rows(handle.contacts, contact_of, {first, count, contacts, contact_size}, "contacts");
  });
}

tamis_status tamis_detector_statistics(tamis_detector* detector, tamis_statistics* statistics) {
  return with(detector, [&](tamis_detector& handle) {
    write_sized(statistics_of(handle.detector->statistics(), handle.stage_names), statistics, "statistics");
  });
}

#include "c/detector.hpp"

#include <algorithm>
#include <string>

#include "c/mesh.hpp"
#include "c/options.hpp"
#include "c/sized.hpp"

using namespace tamis::c;

namespace {

tamis::StoredType known_stored(int32_t stored) {
  if (stored != TAMIS_FLOAT64 && stored != TAMIS_FLOAT32)
    throw InvalidArgument("stored is " + std::to_string(stored) + ": give TAMIS_FLOAT64 or TAMIS_FLOAT32");
  return static_cast<tamis::StoredType>(stored);
}

}  // namespace

tamis_status tamis_detector_create(const tamis_mesh* mesh, const tamis_options* options, tamis_detector** detector) {
  return make_handle(detector, [&](tamis_detector& handle) {
    const auto& of = made<tamis::InvalidMesh>(mesh, "mesh");
    handle.object.emplace(of, options_of(read_options(options), of.vertex_count()));
  });
}

void tamis_detector_free(tamis_detector* detector) { delete detector; }

const char* tamis_detector_message(const tamis_detector* detector) { return message_of(detector); }

tamis_status tamis_detector_contacts(tamis_detector* detector, const tamis_step* step, size_t* count) {
  return ask(detector, step, [&](tamis_detector& handle, const tamis::Step& s, const tamis::QueryOptions& q) {
    keep_rows(handle.contacts, count, [&] { return handle.object->contacts(s, q); });
  });
}

tamis_status tamis_detector_earliest(tamis_detector* detector, const tamis_step* step, double* toi_lower,
                                     double* toi_upper, size_t* count) {
  return ask(detector, step, [&](tamis_detector& handle, const tamis::Step& s, const tamis::QueryOptions& q) {
    const FirstTimes times = first_times(toi_lower, toi_upper, count);
    times.write(handle, handle.object->earliest(s, q));
  });
}

tamis_status tamis_detector_is_free(tamis_detector* detector, const tamis_step* step, int* is_free) {
  return ask(detector, step, [&](tamis_detector& handle, const tamis::Step& s, const tamis::QueryOptions& q) {
    required(is_free, "is_free") = handle.object->is_free(s, q) ? 1 : 0;
  });
}

tamis_status tamis_detector_safe_step(tamis_detector* detector, const tamis_step* step, double keep,
                                      tamis_safe_step* answer) {
  return ask(detector, step, [&](tamis_detector& handle, const tamis::Step& s, const tamis::QueryOptions& q) {
    write_sized(tamis_safe_step{}, answer, "answer");  // refuses a bad `answer` before the work
    write_sized(answer_of(handle.object->safe_step(s, keep, q)), answer, "answer");
  });
}

tamis_status tamis_detector_truncate(tamis_detector* detector, const tamis_step* step, double keep, int32_t stored,
                                     double* positions, double* fractions, int* is_free) {
  return ask(detector, step, [&](tamis_detector& handle, const tamis::Step& s, const tamis::QueryOptions& q) {
    double& first = required(positions, "positions");
    int& free = required(is_free, "is_free");
    const tamis::TruncatedStep reached = handle.object->truncate(s, keep, q, known_stored(stored));
    copy_points(reached.positions, &first);
    if (fractions) std::copy(reached.fractions.begin(), reached.fractions.end(), fractions);
    free = reached.is_free ? 1 : 0;
  });
}

tamis_status tamis_detector_copy_contacts(tamis_detector* detector, size_t first, size_t count, tamis_contact* contacts,
                                          size_t contact_size) {
  return copy_contacts(detector, {first, count, contacts, contact_size});
}

tamis_status tamis_detector_statistics(tamis_detector* detector, tamis_statistics* statistics) {
  return copy_statistics(detector, statistics);
}

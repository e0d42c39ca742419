// The handle of a detector, and what all calls with it share.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "c/failure.hpp"
#include "c/sized.hpp"
#include "c/step.hpp"
#include "tamis/detector.hpp"
#include "tamis/turn.hpp"

struct tamis_detector {
  tamis::c::Outcome outcome;
  std::optional<tamis::Detector> detector;  ///< none if it could not be made
  std::atomic_flag is_asked;
  std::vector<tamis::Contact> contacts;            ///< of the last question about a step
  std::vector<tamis::NearPair> near;               ///< of the last question for them
  std::vector<tamis::Intersection> intersections;  ///< the same
  std::vector<std::string> stage_names;            ///< ended by zeros, as C wants them
};

namespace tamis::c {

/// Runs `work(handle)` unless another call with the handle is running: then its outcome belongs to that one.
template <class Work>
tamis_status with(tamis_detector* handle, const Work& work) noexcept {
  if (!handle) return TAMIS_INVALID_ARGUMENT;
  try {
    const Turn turn(handle->is_asked);
    if (!handle->detector) return handle->outcome.status();  // it still says why it was not made
    return attempt(handle->outcome, [&] { work(*handle); });
  } catch (const Busy&) {
    return TAMIS_BUSY;
  }
}

/// Of one question; none: the detector's.
inline std::optional<double> separation(const double* given) {
  return given ? std::optional<double>(*given) : std::nullopt;
}

inline AtStart at_start(int32_t given) {
  if (given != TAMIS_REPORT && given != TAMIS_IGNORE && given != TAMIS_FAIL)
    throw InvalidOptions("at_start is " + std::to_string(given) + ": give TAMIS_REPORT, TAMIS_IGNORE or TAMIS_FAIL");
  return static_cast<AtStart>(given);
}

/// Runs `work(handle, step, options)`.
template <class Work>
tamis_status ask(tamis_detector* handle, const tamis_step* step, const Work& work) noexcept {
  return with(handle, [&](tamis_detector& h) {
    h.contacts.clear();
    const tamis_step given = read_sized(step, "step");
    work(h, step_of(given), QueryOptions{separation(given.min_separation), at_start(given.at_start)});
  });
}

/// Where the earliest contact goes.
struct FirstTimes {
  double *toi_lower, *toi_upper;
  std::size_t* count;

  void write(tamis_detector& handle, const EarliestContact& first) const {
    if (first.contact) handle.contacts.push_back(*first.contact);
    *toi_lower = first.toi_lower;
    *toi_upper = first.toi_upper;
    *count = handle.contacts.size();
  }
};

inline FirstTimes first_times(double* toi_lower, double* toi_upper, std::size_t* count) {
  return {&required(toi_lower, "toi_lower"), &required(toi_upper, "toi_upper"), &required(count, "count")};
}

/// Where a caller wants part of an answer.
struct Destination {
  std::size_t first, count;
  void* array;
  std::size_t element_size;
};

/// Copies rows of an answer, each as `convert` gives it to C.
template <class Row, class Convert>
void copy_rows(const std::vector<Row>& rows, const Convert& convert, const Destination& to, const char* name) {
  if (to.first > rows.size() || to.count > rows.size() - to.first)
    throw InvalidArgument(std::string(name) + " " + std::to_string(to.first) + " and " + std::to_string(to.count) +
                          " of them: the last question has " + std::to_string(rows.size()));
  check_size(to.element_size, sizeof(int32_t), name);
  if (to.count > 0) required(static_cast<unsigned char*>(to.array), name);
  for (std::size_t i = 0; i < to.count; ++i) write_element(convert(rows[to.first + i]), to.array, i, to.element_size);
}

}  // namespace tamis::c

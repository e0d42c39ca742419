// The handle of a detector, and what all calls with it share.
#pragma once
#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "c/failure.hpp"
#include "c/sized.hpp"
#include "c/step.hpp"
#include "tamis/detector.hpp"

struct tamis_detector {
  tamis::c::Outcome outcome;
  std::optional<tamis::Detector> detector;  ///< none if it could not be made
  std::atomic_flag is_asking;
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
  if (handle->is_asking.test_and_set(std::memory_order_acquire)) return TAMIS_BUSY;
  const tamis_status status = handle->detector ? attempt(handle->outcome, [&] { work(*handle); })
                                               : handle->outcome.status();  // it still says why it was not made
  handle->is_asking.clear(std::memory_order_release);
  return status;
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

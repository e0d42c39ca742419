// The common part of handles that answer questions, of a detector and of a world.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "c/answers.hpp"
#include "c/handle.hpp"
#include "c/sized.hpp"
#include "numbers/busy_guard.hpp"
#include "tamis/options.hpp"

namespace tamis::c {

/// The handle of a detector or world, and its last answers. `contacts` is empty unless the last question about motion
/// was for contacts or the earliest one.
template <class Asked, class ContactRow, class NearRow, class IntersectionRow>
struct AskedHandle : Handle<std::optional<Asked>> {
  std::atomic_flag is_asked;
  std::vector<ContactRow> contacts;
  std::vector<NearRow> near;
  std::vector<IntersectionRow> intersections;
  std::vector<std::string> stage_names;  ///< each ends with a zero, as C requires
};

/// Runs `work(handle)`, unless another call with the handle is running: that call keeps the handle's outcome.
template <class AnyHandle, class Work>
tamis_status with(AnyHandle* handle, const Work& work) noexcept {
  if (!handle) return TAMIS_INVALID_ARGUMENT;
  try {
    const BusyGuard guard(handle->is_asked);
    return with_object(handle, [&](auto&) { work(*handle); });
  } catch (const Busy&) {
    return TAMIS_BUSY;
  }
}

/// The separation of one question; none if it is the detector's.
inline std::optional<double> separation(const double* given) {
  return given ? std::optional<double>(*given) : std::nullopt;
}

inline AtStart at_start(int32_t given) {
  if (given != TAMIS_REPORT && given != TAMIS_IGNORE && given != TAMIS_FAIL)
    throw InvalidOptions("at_start is " + std::to_string(given) + ": give TAMIS_REPORT, TAMIS_IGNORE or TAMIS_FAIL");
  return static_cast<AtStart>(given);
}

inline PathOptions path_options_of(const tamis_path_options& given) {
  PathOptions options{separation(given.min_separation), at_start(given.at_start)};
  if (given.tolerance != 0) options.tolerance = given.tolerance;
  return options;
}

/// Pairs by themselves that touch at the start are reported, without a choice.
inline void require_report(int32_t at_start) {
  if (at_start != TAMIS_REPORT)
    throw InvalidOptions("at_start is " + std::to_string(at_start) +
                         ": it is for questions to a detector, leave it 0 for pairs by themselves");
}

/// Keeps the rows of an answer, which `find` returns, and writes their number. There are none if the call fails.
template <class Row, class Find>
void keep_rows(std::vector<Row>& rows, std::size_t* count, const Find& find) {
  rows.clear();
  std::size_t& number = required(count, "count");
  const auto& found = find();
  rows.assign(found.begin(), found.end());
  number = rows.size();
}

/// Where a call writes the times of the earliest contact.
struct FirstTimes {
  double *toi_lower, *toi_upper;
  std::size_t* count;

  template <class AnyHandle, class Earliest>
  void write(AnyHandle& handle, const Earliest& first) const {
    if (first.contact) handle.contacts.push_back(*first.contact);
    *toi_lower = first.toi_lower;
    *toi_upper = first.toi_upper;
    *count = handle.contacts.size();
  }
};

inline FirstTimes first_times(double* toi_lower, double* toi_upper, std::size_t* count) {
  return {&required(toi_lower, "toi_lower"), &required(toi_upper, "toi_upper"), &required(count, "count")};
}

/// The rows of an answer that a caller wants, and the array for them.
struct Destination {
  std::size_t first, count;
  void* array;
  std::size_t element_size;
};

/// Copies rows of an answer, each converted by `convert`.
template <class Row, class Convert>
void copy_rows(const std::vector<Row>& rows, const Convert& convert, const Destination& to, const char* name) {
  if (to.first > rows.size() || to.count > rows.size() - to.first)
    throw InvalidArgument(std::string(name) + " " + std::to_string(to.first) + " and " + std::to_string(to.count) +
                          " of them: the last question has " + std::to_string(rows.size()));
  check_size(to.element_size, sizeof(int32_t), name);
  if (to.count > 0) required(static_cast<unsigned char*>(to.array), name);
  for (std::size_t i = 0; i < to.count; ++i) write_element(convert(rows[to.first + i]), to.array, i, to.element_size);
}

template <class AnyHandle>
tamis_status copy_contacts(AnyHandle* handle, const Destination& to) noexcept {
  return with(handle, [&](AnyHandle& h) {
    copy_rows(
        h.contacts, [](const auto& row) { return contact_of(row); }, to, "contacts");
  });
}
template <class AnyHandle>
tamis_status copy_near(AnyHandle* handle, const Destination& to) noexcept {
  return with(handle, [&](AnyHandle& h) {
    copy_rows(
        h.near, [](const auto& row) { return near_pair_of(row); }, to, "pairs");
  });
}
template <class AnyHandle>
tamis_status copy_intersections(AnyHandle* handle, const Destination& to) noexcept {
  return with(handle, [&](AnyHandle& h) {
    copy_rows(
        h.intersections, [](const auto& row) { return intersection_of(row); }, to, "intersections");
  });
}

template <class AnyHandle>
tamis_status copy_statistics(AnyHandle* handle, tamis_statistics* to) noexcept {
  return with(handle, [&](AnyHandle& h) {
    write_sized(statistics_of(h.object->statistics(), h.stage_names), to, "statistics");
  });
}

}  // namespace tamis::c

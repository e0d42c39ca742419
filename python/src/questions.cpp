#include "python/src/questions.hpp"

#include "python/src/answers.hpp"
#include "python/src/looking.hpp"
#include "python/src/statistics.hpp"

namespace tamis::python {
namespace {

Step step_of(const Rows& start, const Rows& end) { return {positions(start), positions(end)}; }

QueryOptions on_path(QueryOptions options, double tolerance) {
  options.tolerance = tolerance;
  return options;
}

}  // namespace

Questions::Questions(const Mesh& mesh, const Asking& asking)
    : asker_(asking), detector_(mesh, asker_.with_callbacks(asking.options)) {}

nb::object Questions::contacts(const Rows& start, const Rows& end, const QueryOptions& q) {
  std::vector<Contact> found = spare_->take();
  asker_.ask([&] { detector_.contacts(step_of(start, end), found, q); });
  return own_contacts(std::move(found), spare_);
}

nb::tuple Questions::earliest(const Rows& start, const Rows& end, const QueryOptions& q) {
  EarliestContact first;
  asker_.ask([&] { first = detector_.earliest(step_of(start, end), q); });
  return earliest_tuple(first);
}

bool Questions::is_free(const Rows& start, const Rows& end, const QueryOptions& q) {
  bool free = false;
  asker_.ask([&] { free = detector_.is_free(step_of(start, end), q); });
  return free;
}

nb::object Questions::contacts_on_path(const Path& path, double tolerance, const QueryOptions& q) {
  std::vector<Contact> found = spare_->take();
  asker_.ask([&] { found = detector_.contacts(path, on_path(q, tolerance)); });
  return own_contacts(std::move(found), spare_);
}

nb::tuple Questions::earliest_on_path(const Path& path, double tolerance, const QueryOptions& q) {
  EarliestContact first;
  asker_.ask([&] { first = detector_.earliest(path, on_path(q, tolerance)); });
  return earliest_tuple(first);
}

bool Questions::is_free_on_path(const Path& path, double tolerance, const QueryOptions& q) {
  bool free = false;
  asker_.ask([&] { free = detector_.is_free(path, on_path(q, tolerance)); });
  return free;
}

nb::tuple Questions::safe_step(const Rows& start, const Rows& end, double keep, const QueryOptions& q) {
  SafeStep safe;
  asker_.ask([&] { safe = detector_.safe_step(step_of(start, end), keep, q); });
  return step_tuple(safe);
}

nb::tuple Questions::truncate(const Rows& start, const Rows& end, double keep, const QueryOptions& q, bool as_float32) {
  const Stored stored = as_float32 ? Stored::float32 : Stored::float64;
  TruncatedStep step;
  asker_.ask([&] { step = detector_.truncate(step_of(start, end), keep, q, stored); });
  return nb::make_tuple(own<double>(std::move(step.positions), 3), own<double>(std::move(step.parts), 0), step.is_free);
}

nb::object Questions::pairs_within(const Rows& at, double distance) {
  std::vector<NearPair> found;
  asker_.ask([&] { found = detector_.pairs_within(positions(at), distance); });
  return own_bytes(std::move(found));
}

nb::object Questions::intersections(const Rows& at) {
  std::vector<Intersection> found;
  asker_.ask([&] { found = detector_.intersections(positions(at)); });
  return own_bytes(std::move(found));
}

bool Questions::has_intersection(const Rows& at) {
  bool found = false;
  asker_.ask([&] { found = detector_.has_intersection(positions(at)); });
  return found;
}

void Questions::write_step(const std::filesystem::path& path, const ContactBytes& contacts, const Rows& start,
                           const Rows& end, const QueryOptions& q) {
  asker_.ask([&] { python::write_step(path, detector_, step_of(start, end), q, contacts_in(contacts)); });
}

void Questions::write_path(const std::filesystem::path& to, const ContactBytes& contacts, const Path& path,
                           double tolerance, const QueryOptions& q) {
  asker_.ask([&] { python::write_path(to, detector_, path, on_path(q, tolerance), contacts_in(contacts)); });
}

nb::dict Questions::statistics() {
  const Turn turn = asker_.turn();
  return as_dict(detector_.statistics());
}

}  // namespace tamis::python

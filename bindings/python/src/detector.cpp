// A detector that lets other Python threads run while it works, and stops when Python wants it to.
#include "tamis/detector.hpp"

#include <nanobind/stl/filesystem.h>

#include "python/src/answers.hpp"
#include "python/src/asker.hpp"
#include "python/src/bindings.hpp"
#include "python/src/collected.hpp"
#include "python/src/contact_array.hpp"
#include "python/src/looking.hpp"
#include "python/src/statistics.hpp"

namespace tamis::python {
namespace {

Step motion(const Rows& start, const Rows& end) { return step_of(start, end); }
const Path& motion(const Path& path) { return path; }
/// The options of a question about a step, given by its two ends, or about a path.
template <class... Motion>
using OptionsOf = std::conditional_t<sizeof...(Motion) == 1, PathOptions, QueryOptions>;

/// Where a question takes `given`: both ends of a step, or a path.
class Questions {
 public:
  Questions(const Mesh& mesh, const Asking& asking)
      : asker_(asking), detector_(mesh, asker_.with_callbacks(asking.options)) {}

  template <class... Motion>
  nb::object contacts(const OptionsOf<Motion...>& q, const Motion&... given) {
    std::vector<Contact> found = spare_->take();
    asker_.ask([&] { find(motion(given...), q, found); });
    return own_contacts(std::move(found), spare_);
  }
  template <class... Motion>
  nb::tuple earliest(const OptionsOf<Motion...>& q, const Motion&... given) {
    return earliest_tuple(asker_.answer([&] { return detector_.earliest(motion(given...), q); }));
  }
  template <class... Motion>
  bool is_free(const OptionsOf<Motion...>& q, const Motion&... given) {
    return asker_.answer([&] { return detector_.is_free(motion(given...), q); });
  }
  /// As looking.hpp has it.
  template <class... Motion>
  void write(const std::filesystem::path& to, const ContactBytes& contacts, const OptionsOf<Motion...>& q,
             const Motion&... given) {
    asker_.ask([&] { write_motion(to, detector_, motion(given...), q, contacts_in(contacts)); });
  }

  nb::tuple safe_step(const QueryOptions& q, double keep, const Rows& start, const Rows& end) {
    return step_tuple(asker_.answer([&] { return detector_.safe_step(step_of(start, end), keep, q); }));
  }
  nb::tuple truncate(const QueryOptions& q, double keep, const Rows& start, const Rows& end, bool as_float32) {
    const StoredType stored = as_float32 ? StoredType::float32 : StoredType::float64;
    TruncatedStep step = asker_.answer([&] { return detector_.truncate(step_of(start, end), keep, q, stored); });
    return nb::make_tuple(own<double>(std::move(step.positions)), own<double>(std::move(step.fractions)), step.is_free);
  }

  nb::object pairs_within(const Rows& at, double distance) {
    return own_bytes(asker_.answer([&] { return copied(detector_.pairs_within(positions(at), distance)); }));
  }
  nb::object intersections(const Rows& at) {
    return own_bytes(asker_.answer([&] { return copied(detector_.intersections(positions(at))); }));
  }
  bool has_intersection(const Rows& at) {
    return asker_.answer([&] { return detector_.has_intersection(positions(at)); });
  }

  nb::dict statistics() {
    const BusyGuard guard = asker_.guard();
    return as_dict(detector_.statistics());
  }

  int traverse(visitproc visit, void* arg) const { return asker_.traverse(visit, arg); }
  void clear() { asker_.clear(); }

 private:
  void find(const Step& step, const QueryOptions& q, std::vector<Contact>& found) {
    keep(detector_.contacts(step, q), found);
  }
  void find(const Path& path, const PathOptions& q, std::vector<Contact>& found) {
    keep(detector_.contacts(path, q), found);
  }
  static void keep(std::span<const Contact> contacts, std::vector<Contact>& found) {
    found.assign(contacts.begin(), contacts.end());
  }

  Asker asker_;
  Detector detector_;
  std::shared_ptr<SpareContacts> spare_ = std::make_shared<SpareContacts>();
};

}  // namespace

void bind_detector(nb::module_& module) {
  nb::class_<Questions>(module, "Detector", nb::type_slots(collected<Questions>), nb::is_weak_referenceable())
      .def(nb::init<const Mesh&, const Asking&>())
      .def("contacts", &Questions::contacts<Rows, Rows>)
      .def("contacts", &Questions::contacts<Path>)
      .def("earliest", &Questions::earliest<Rows, Rows>)
      .def("earliest", &Questions::earliest<Path>)
      .def("is_free", &Questions::is_free<Rows, Rows>)
      .def("is_free", &Questions::is_free<Path>)
      .def("write", &Questions::write<Rows, Rows>)
      .def("write", &Questions::write<Path>)
      .def("safe_step", &Questions::safe_step)
      .def("truncate", &Questions::truncate)
      .def("pairs_within", &Questions::pairs_within)
      .def("intersections", &Questions::intersections)
      .def("has_intersection", &Questions::has_intersection)
      .def("statistics", &Questions::statistics);
}

}  // namespace tamis::python

#include "tamis/detector.hpp"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <atomic>
#include <cstddef>
#include <optional>

#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"
#include "python/src/contact_array.hpp"
#include "python/src/errors.hpp"
#include "python/src/layout.hpp"
#include "python/src/options.hpp"
#include "python/src/signals.hpp"

namespace tamis::python {
namespace {

/// Of one question; none: the detector's.
using Separation = std::optional<double>;

/// A detector that lets other Python threads run while it works, and stops when Python wants it to.
class Questions {
 public:
  Questions(const Mesh& mesh, const Asking& asking)
      : accepts_(asking.accepts), signals_(asking.is_cancelled), detector_(mesh, with_callbacks(asking.options)) {}

  /// What Python's garbage collector must know: a callable may refer back to its detector.
  int traverse(visitproc visit, void* arg) const {
    Py_VISIT(accepts_.ptr());
    Py_VISIT(signals_.is_cancelled().ptr());
    return 0;
  }
  void clear() {
    accepts_ = nb::none();
    signals_.clear();
  }

  nb::object contacts(const Rows& start, const Rows& end, Separation d) {
    std::vector<Contact> found = spare_->take();
    ask([&] { detector_.contacts({positions(start), positions(end)}, found, d); });
    return own_contacts(std::move(found), spare_);
  }

  nb::tuple earliest(const Rows& start, const Rows& end, Separation d) {
    EarliestContact first;
    ask([&] { first = detector_.earliest({positions(start), positions(end)}, d); });
    std::vector<Contact> contact;
    if (first.contact) contact.push_back(*first.contact);
    return nb::make_tuple(first.toi_lower, first.toi_upper, own_bytes(std::move(contact)));
  }

  bool is_free(const Rows& start, const Rows& end, Separation d) {
    bool free = false;
    ask([&] { free = detector_.is_free({positions(start), positions(end)}, d); });
    return free;
  }

  nb::tuple keep_distance(const Rows& start, const Rows& end, double fraction, Separation d) {
    SafeStep safe;
    ask([&] { safe = detector_.keep_distance({positions(start), positions(end)}, fraction, d); });
    if (!safe.pair) return nb::make_tuple(safe.lower, safe.upper, nb::none());
    const auto& v = safe.pair->vertices;
    return nb::make_tuple(
        safe.lower, safe.upper,
        nb::make_tuple(static_cast<int>(safe.pair->kind), nb::make_tuple(v[0], v[1], v[2], v[3]), safe.pair->distance));
  }

  nb::object near(const Rows& at, double distance) {
    std::vector<NearPair> found;
    ask([&] { found = detector_.near(positions(at), distance); });
    return own_bytes(std::move(found));
  }

  nb::object intersections(const Rows& at) {
    std::vector<Intersection> found;
    ask([&] { found = detector_.intersections(positions(at)); });
    return own_bytes(std::move(found));
  }

  bool has_intersection(const Rows& at) {
    bool found = false;
    ask([&] { found = detector_.has_intersection(positions(at)); });
    return found;
  }

  nb::dict statistics() {
    const Turn turn(is_asking_);
    return as_dict(detector_.statistics());
  }

 private:
  /// One question at a time: a second one is refused, from another thread or from the filter.
  class Turn {
   public:
    explicit Turn(std::atomic_flag& flag) : flag_(flag) {
      if (flag_.test_and_set(std::memory_order_acquire)) throw Busy();
    }
    ~Turn() { flag_.clear(std::memory_order_release); }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

   private:
    std::atomic_flag& flag_;
  };

  template <class Work>
  void ask(const Work& work) {
    const Turn turn(is_asking_);
    signals_.begin();
    try {
      const nb::gil_scoped_release unlocked;
      work();
    } catch (const Cancelled&) {
      signals_.rethrow();
      throw;
    }
  }

  /// The library copies its options, so that these refer to what is kept here.
  Options with_callbacks(Options options) {
    options.is_cancelled = [this] { return signals_.ask(); };
    if (accepts_.is_none()) return options;
    options.filter.accepts = [this](PairKind kind, const std::array<Index, 4>& v) {
      const nb::gil_scoped_acquire lock;
      return nb::cast<bool>(nb::bool_(accepts_(static_cast<int>(kind), nb::make_tuple(v[0], v[1], v[2], v[3]))));
    };
    return options;
  }

  static nb::dict as_dict(const Statistics& s) {
    nb::dict stages, seconds, decided_by, all;
    for (const StageCount& stage : s.stages)
      stages[nb::str(stage.name.data(), stage.name.size())] = nb::make_tuple(stage.vf, stage.ee, stage.ve, stage.vv);
    seconds["bounds"] = s.seconds.bounds;
    seconds["build"] = s.seconds.build;
    seconds["traverse"] = s.seconds.traverse;
    seconds["filter"] = s.seconds.filter;
    seconds["solve"] = s.seconds.solve;
    seconds["total"] = s.seconds.total;
    decided_by["lanes"] = s.decided_by.lanes;
    decided_by["scalar"] = s.decided_by.scalar;
    decided_by["exact"] = s.decided_by.exact;
    decided_by["unresolved"] = s.decided_by.unresolved;
    all["method"] = std::string(name_of(s.method));
    all["isa"] = std::string(name_of(s.isa));
    all["threads"] = s.threads;
    all["stages"] = stages;
    all["decided_by"] = decided_by;
    all["seconds"] = seconds;
    all["nodes_visited"] = s.nodes_visited;
    all["triangle_pairs"] = s.triangle_pairs;
    all["triangles_in_free_patches"] = s.triangles_in_free_patches;
    all["rebuilt"] = s.rebuilt;
    all["memory_bytes"] = s.memory_bytes;
    return all;
  }

  nb::object accepts_;
  Signals signals_;
  Detector detector_;
  std::shared_ptr<SpareContacts> spare_ = std::make_shared<SpareContacts>();
  std::atomic_flag is_asking_;
};

int visit_questions(PyObject* self, visitproc visit, void* arg) {
  Py_VISIT(Py_TYPE(self));
  return nb::inst_ready(self) ? nb::inst_ptr<Questions>(self)->traverse(visit, arg) : 0;
}

int clear_questions(PyObject* self) {
  if (nb::inst_ready(self)) nb::inst_ptr<Questions>(self)->clear();
  return 0;
}

PyType_Slot collected[] = {{Py_tp_traverse, reinterpret_cast<void*>(&visit_questions)},
                           {Py_tp_clear, reinterpret_cast<void*>(&clear_questions)},
                           {0, nullptr}};

nb::dict contact_layout() {
  return Layout(sizeof(Contact))
      .field("kind", "u1", offsetof(Contact, kind))
      .field("certainty", "u1", offsetof(Contact, certainty))
      .field("vertices", "(4,)i4", offsetof(Contact, vertices))
      .field("toi_lower", "f8", offsetof(Contact, toi_lower))
      .field("toi_upper", "f8", offsetof(Contact, toi_upper))
      .field("u", "f8", offsetof(Contact, u))
      .field("v", "f8", offsetof(Contact, v))
      .field("normal", "(3,)f8", offsetof(Contact, normal))
      .dict();
}

nb::dict near_layout() {
  return Layout(sizeof(NearPair))
      .field("kind", "u1", offsetof(NearPair, kind))
      .field("corners", "u1", offsetof(NearPair, corners))
      .field("vertices", "(4,)i4", offsetof(NearPair, vertices))
      .field("distance", "f8", offsetof(NearPair, distance))
      .field("u", "f8", offsetof(NearPair, u))
      .field("v", "f8", offsetof(NearPair, v))
      .field("direction", "(3,)f8", offsetof(NearPair, direction))
      .dict();
}

nb::dict intersection_layout() {
  return Layout(sizeof(Intersection))
      .field("edge", "(2,)i4", offsetof(Intersection, edge))
      .field("face", "(3,)i4", offsetof(Intersection, face))
      .field("s_lower", "f8", offsetof(Intersection, s_lower))
      .field("s_upper", "f8", offsetof(Intersection, s_upper))
      .field("u", "f8", offsetof(Intersection, u))
      .field("v", "f8", offsetof(Intersection, v))
      .dict();
}

}  // namespace

void bind_detector(nb::module_& module) {
  nb::class_<Questions>(module, "Detector", nb::type_slots(collected), nb::is_weak_referenceable())
      .def(nb::init<const Mesh&, const Asking&>())
      .def("contacts", &Questions::contacts, nb::arg(), nb::arg(), nb::arg().none())
      .def("earliest", &Questions::earliest, nb::arg(), nb::arg(), nb::arg().none())
      .def("is_free", &Questions::is_free, nb::arg(), nb::arg(), nb::arg().none())
      .def("keep_distance", &Questions::keep_distance, nb::arg(), nb::arg(), nb::arg(), nb::arg().none())
      .def("near", &Questions::near)
      .def("intersections", &Questions::intersections)
      .def("has_intersection", &Questions::has_intersection)
      .def("statistics", &Questions::statistics);
  module.def("near_layout", &near_layout);
  module.def("intersection_layout", &intersection_layout);
  module.def("contact_layout", &contact_layout);
}

}  // namespace tamis::python

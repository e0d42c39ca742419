// A world of bodies that lets other Python threads run while it works, and stops when Python wants it to.
#include "tamis/world.hpp"

#include <span>

#include "python/src/answers.hpp"
#include "python/src/asker.hpp"
#include "python/src/bindings.hpp"
#include "python/src/collected.hpp"
#include "python/src/statistics.hpp"
#include "python/src/world/motions.hpp"

namespace tamis::python {
namespace {

class Bodies {
 public:
  explicit Bodies(const Asking& asking) : asker_(asking), world_(asker_.with_callbacks(asking.options)) {}

  /// All or none.
  template <class Motions, class... Arrays>
  nb::object add(const Shape& shape, const Arrays&... arrays) {
    const Motions motions{arrays...};
    std::vector<BodyId> added;
    asker_.ask([&] {
      try {
        for (std::size_t i = 0; i < motions.count(); ++i) added.push_back(world_.add(shape, motions[i]));
      } catch (...) {
        for (const BodyId body : added) world_.remove(body);
        throw;
      }
    });
    return own<BodyId>(std::move(added));
  }

  /// All or none. REQUIRES: as many bodies as motions, each once, which the Python side sees to.
  template <class Motions, class... Arrays>
  void move(const Indices& bodies, const Arrays&... arrays) {
    const Motions motions{arrays...};
    change(of(bodies), [&] {
      std::vector<BodyMotion> before;
      try {
        for (const BodyId body : of(bodies)) {
          before.push_back(world_.motion(body));
          world_.move(body, motions[before.size() - 1]);
        }
      } catch (...) {
        for (std::size_t i = 0; i < before.size(); ++i) world_.move(of(bodies)[i], std::move(before[i]));
        throw;
      }
    });
  }

  /// REQUIRES: each once, as above.
  void remove(const Indices& bodies) {
    change(of(bodies), [&] {
      for (const BodyId body : of(bodies)) world_.remove(body);
    });
  }

  void set_enabled(const Indices& bodies, bool is_enabled) {
    change(of(bodies), [&] {
      for (const BodyId body : of(bodies)) world_.set_enabled(body, is_enabled);
    });
  }

  void set_radius(const Indices& bodies, double radius) {
    change(of(bodies), [&] {
      for (const BodyId body : of(bodies)) world_.set_radius(body, radius);
    });
  }

  void set_may_touch(const IndexRowsIn<2>& pairs, bool may_touch) {
    const std::span<const BodyId> bodies(pairs.data(), pairs.size());
    change(bodies, [&] {
      for (std::size_t i = 0; i < bodies.size(); i += 2) world_.set_may_touch(bodies[i], bodies[i + 1], may_touch);
    });
  }

  nb::tuple points_at(BodyId body, double time) {
    BodyPoints found = asker_.answer([&] { return world_.points_at(body, time); });
    const double error = found.error;
    return nb::make_tuple(own<double>(std::move(found.points)), error);
  }

  nb::object contacts(const QueryOptions& q) {
    return own_bytes(asker_.answer([&] { return world_.contacts(q); }));
  }
  nb::object first_contacts(const QueryOptions& q) {
    return own_bytes(asker_.answer([&] { return world_.first_contacts(q); }));
  }
  nb::tuple earliest(const QueryOptions& q) {
    return earliest_tuple(asker_.answer([&] { return world_.earliest(q); }));
  }
  /// Of chains, one for each of the bodies, then again for the next motion.
  nb::tuple earliest_many(const Indices& bodies, const Chains& chains, const QueryOptions& q) {
    const ByChains given{chains};
    const auto found = asker_.answer([&] {
      std::vector<BodyMotion> motions;
      for (std::size_t i = 0; i < given.count(); ++i) motions.push_back(given[i]);
      return world_.earliest_many(of(bodies), motions, q);
    });
    return earliest_columns(found);
  }
  bool is_free(const QueryOptions& q) {
    return asker_.answer([&] { return world_.is_free(q); });
  }
  nb::object pairs_within(double distance) {
    return own_bytes(asker_.answer([&] { return world_.pairs_within(distance); }));
  }
  nb::object intersections() {
    return own_bytes(asker_.answer([&] { return world_.intersections(); }));
  }
  bool has_intersection() {
    return asker_.answer([&] { return world_.has_intersection(); });
  }
  nb::tuple safe_step(double keep, const QueryOptions& q) {
    return step_tuple(asker_.answer([&] { return world_.safe_step(keep, q); }));
  }

  nb::dict statistics() {
    const BusyGuard guard = asker_.guard();
    return as_dict(world_.statistics());
  }

  int traverse(visitproc visit, void* arg) const { return asker_.traverse(visit, arg); }
  void clear() { asker_.clear(); }

 private:
  static std::span<const BodyId> of(const Indices& bodies) { return {bodies.data(), bodies.shape(0)}; }

  /// One that is not there is refused before anything has changed.
  template <class Change>
  void change(std::span<const BodyId> bodies, const Change& work) {
    asker_.ask([&] {
      for (const BodyId body : bodies) static_cast<void>(world_.motion(body));
      work();
    });
  }

  Asker asker_;
  World world_;
};

}  // namespace

void bind_world(nb::module_& module) {
  nb::class_<Bodies>(module, "World", nb::type_slots(collected<Bodies>), nb::is_weak_referenceable())
      .def(nb::init<const Asking&>())
      .def("add", &Bodies::add<AtPoses, PoseRows>)
      .def("add", &Bodies::add<ByChains, Chains>)
      .def("add", &Bodies::add<OneDeforming, PointRows, PointRows>)
      .def("move", &Bodies::move<AtPoses, PoseRows>)
      .def("move", &Bodies::move<ByChains, Chains>)
      .def("move", &Bodies::move<OneDeforming, PointRows, PointRows>)
      .def("remove", &Bodies::remove)
      .def("set_enabled", &Bodies::set_enabled)
      .def("set_radius", &Bodies::set_radius)
      .def("set_may_touch", &Bodies::set_may_touch)
      .def("points_at", &Bodies::points_at)
      .def("contacts", &Bodies::contacts)
      .def("first_contacts", &Bodies::first_contacts)
      .def("earliest", &Bodies::earliest)
      .def("earliest_many", &Bodies::earliest_many)
      .def("is_free", &Bodies::is_free)
      .def("pairs_within", &Bodies::pairs_within)
      .def("intersections", &Bodies::intersections)
      .def("has_intersection", &Bodies::has_intersection)
      .def("safe_step", &Bodies::safe_step)
      .def("statistics", &Bodies::statistics);
}

}  // namespace tamis::python

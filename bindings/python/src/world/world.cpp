// A world of bodies that lets other Python threads run while it works, and stops when Python wants it to.
#include "tamis/world.hpp"

#include <array>
#include <span>
#include <vector>

#include "python/src/answers.hpp"
#include "python/src/asker.hpp"
#include "python/src/bindings.hpp"
#include "python/src/collected.hpp"
#include "python/src/statistics.hpp"
#include "python/src/world/configurations.hpp"
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
    return own<BodyId>(asker_.answer([&] { return world_.add_many(shape, all_of(motions)); }));
  }

  /// All or none. REQUIRES: as many bodies as motions, each once, which the Python side sees to.
  template <class Motions, class... Arrays>
  void move(const Indices& bodies, const Arrays&... arrays) {
    const Motions motions{arrays...};
    asker_.ask([&] { world_.move_many(of(bodies), all_of(motions)); });
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
    const auto* first = reinterpret_cast<const std::array<BodyId, 2>*>(pairs.data());
    asker_.ask([&] { world_.set_may_touch({first, pairs.shape(0)}, may_touch); });
  }

  nb::tuple points_at(BodyId body, double time) {
    BodyPoints found = asker_.answer([&] { return world_.points_at(body, time); });
    const double error = found.error;
    return nb::make_tuple(own<double>(std::move(found.points)), error);
  }

  nb::object contacts(const PathOptions& q) {
    return own_bytes(asker_.answer([&] { return world_.contacts(q); }));
  }
  nb::object first_contacts(const PathOptions& q) {
    return own_bytes(asker_.answer([&] { return world_.first_contacts(q); }));
  }
  nb::tuple earliest(const PathOptions& q) {
    return earliest_tuple(asker_.answer([&] { return world_.earliest(q); }));
  }
  /// Of chains, one for each of the bodies, then again for the next motion.
  nb::tuple earliest_many(const Indices& bodies, const Chains& chains, const PathOptions& q) {
    const ByChains given{chains};
    const auto found = asker_.answer([&] { return world_.earliest_many(of(bodies), all_of(given), q); });
    return earliest_columns(found);
  }
  bool is_free(const PathOptions& q) {
    return asker_.answer([&] { return world_.is_free(q); });
  }
  nb::object pairs_within(double distance, bool include_static) {
    return own_bytes(asker_.answer([&] { return world_.pairs_within(distance, {include_static}); }));
  }
  nb::object intersections(bool include_static) {
    return own_bytes(asker_.answer([&] { return world_.intersections({include_static}); }));
  }
  bool has_intersection(bool include_static) {
    return asker_.answer([&] { return world_.has_intersection({include_static}); });
  }
  bool has_overlap(bool include_static) {
    return asker_.answer([&] { return world_.has_overlap({include_static}); });
  }
  bool is_closed(BodyId body) {
    return asker_.answer([&] { return world_.is_closed(body); });
  }
  nb::object configurations_are_free(const Linkage& linkage, const ConfigurationRows& all, const PathOptions& q) {
    return flags_of(
        asker_.answer([&] { return world_.configurations_are_free(linkage, numbers_of(all), of_edges(q, false)); }));
  }
  nb::object edges_are_free(const Linkage& linkage, const ConfigurationRows& starts, const ConfigurationRows& ends,
                            bool starts_are_free, const PathOptions& q) {
    return flags_of(asker_.answer([&] {
      return world_.edges_are_free(linkage, numbers_of(starts), numbers_of(ends), of_edges(q, starts_are_free));
    }));
  }
  nb::tuple last_valid(const Linkage& linkage, const ConfigurationRows& starts, const ConfigurationRows& ends,
                       bool starts_are_free, const PathOptions& q) {
    return edge_columns(asker_.answer([&] {
      return world_.last_valid(linkage, numbers_of(starts), numbers_of(ends), of_edges(q, starts_are_free));
    }));
  }
  /// The edge's number, or -1; and the answer about it.
  nb::tuple first_bad_edge(const Linkage& linkage, const ConfigurationRows& waypoints, bool start_is_free,
                           const PathOptions& q) {
    const FirstBadEdge first = asker_.answer(
        [&] { return world_.first_bad_edge(linkage, numbers_of(waypoints), of_edges(q, start_is_free)); });
    return nb::make_tuple(first.edge ? static_cast<std::ptrdiff_t>(*first.edge) : -1, edge_columns({first.answer}));
  }
  nb::tuple roadmap(const Linkage& linkage, const ConfigurationRows& configurations, const IndexRowsIn<2>& edges,
                    const PathOptions& q) {
    const auto* first = reinterpret_cast<const std::array<Index, 2>*>(edges.data());
    const FreeRoadmap found = asker_.answer([&] {
      return world_.roadmap(linkage, numbers_of(configurations), {first, edges.shape(0)}, of_edges(q, false));
    });
    return nb::make_tuple(flags_of(found.configurations), flags_of(found.edges));
  }
  nb::tuple safe_step(double keep, const PathOptions& q) {
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

  static EdgeOptions of_edges(const PathOptions& q, bool starts_are_free) {
    return {q.min_separation, q.tolerance, starts_are_free};
  }

  template <class Motions>
  static std::vector<BodyMotion> all_of(const Motions& motions) {
    std::vector<BodyMotion> all;
    for (std::size_t i = 0; i < motions.count(); ++i) all.push_back(motions[i]);
    return all;
  }

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
      .def("has_overlap", &Bodies::has_overlap)
      .def("is_closed", &Bodies::is_closed)
      .def("safe_step", &Bodies::safe_step)
      .def("configurations_are_free", &Bodies::configurations_are_free)
      .def("edges_are_free", &Bodies::edges_are_free)
      .def("last_valid", &Bodies::last_valid)
      .def("first_bad_edge", &Bodies::first_bad_edge)
      .def("roadmap", &Bodies::roadmap)
      .def("statistics", &Bodies::statistics);
}

}  // namespace tamis::python

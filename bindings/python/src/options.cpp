#include "tamis/options.hpp"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"
#include "python/src/collected.hpp"
#include "python/src/options.hpp"

namespace tamis::python {
namespace {

using Flags = nb::ndarray<const std::uint8_t, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

void set_groups(Asking& asking, const Indices& group_of_vertex, Index group_count, const Flags& may_touch) {
  PairFilter& filter = asking.options.filter;
  filter.group_of_vertex = copy_of<Index>(group_of_vertex);
  filter.group_count = group_count;
  filter.groups_may_touch.assign(may_touch.data(), may_touch.data() + may_touch.size());
}

}  // namespace

void bind_options(nb::module_& module) {
  nb::class_<QueryOptions>(module, "QueryOptions")
      .def(
          "__init__",
          [](QueryOptions* made, std::optional<double> min_separation, const std::string& at_start) {
            new (made) QueryOptions{min_separation, at_start_from_name(at_start)};
          },
          nb::arg().none(), nb::arg());
  nb::class_<PathOptions>(module, "PathOptions")
      .def(
          "__init__",
          [](PathOptions* made, std::optional<double> min_separation, const std::string& at_start,
             std::optional<double> tolerance) {
            new (made)
                PathOptions{min_separation, at_start_from_name(at_start), tolerance.value_or(PathOptions().tolerance)};
          },
          nb::arg().none(), nb::arg(), nb::arg().none());
  nb::class_<Asking>(module, "Options", nb::type_slots(collected<Asking>))
      .def(nb::init<>())
      .def("set_isa", [](Asking& a, const std::string& name) { a.options.isa = isa_from_name(name); })
      .def("set_threads", [](Asking& a, int threads) { a.options.threads = threads; })
      .def("set_min_separation", [](Asking& a, double distance) { a.options.min_separation = distance; })
      .def("set_groups", &set_groups)
      .def("set_radii", [](Asking& a, std::vector<double> radii) { a.options.radii = std::move(radii); })
      .def("set_rings", [](Asking& a, int rings) { a.options.filter.rings = rings; })
      .def("set_filter", [](Asking& a, nb::object accepts) { a.accepts = std::move(accepts); })
      .def("set_is_cancelled", [](Asking& a, nb::object is_cancelled) { a.is_cancelled = std::move(is_cancelled); });
}

}  // namespace tamis::python

#include "tamis/options.hpp"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"
#include "python/src/collected.hpp"
#include "python/src/options.hpp"
#include "tamis/error.hpp"

namespace tamis::python {
namespace {

using Matrix = nb::ndarray<const double, nb::ndim<2>, nb::c_contig, nb::device::cpu>;
using Flags = nb::ndarray<const std::uint8_t, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

HighLevelCulling high_level_from_name(const std::string& name) {
  if (name == "none") return HighLevelCulling::none;
  if (name == "normal-cones") return HighLevelCulling::normal_cones;
  if (name == "star-contours") return HighLevelCulling::star_contours;
  if (name == "subspace") return HighLevelCulling::subspace;
  throw InvalidOptions("no high-level culling is called '" + name +
                       "': use one of none, normal-cones, star-contours, subspace");
}

std::vector<std::string> strings(const std::vector<std::string_view>& names) { return {names.begin(), names.end()}; }

void set_groups(Asking& asking, const Indices& group_of_vertex, Index group_count, const Flags& may_touch) {
  PairFilter& filter = asking.options.filter;
  filter.group_of_vertex = copy_of<Index>(group_of_vertex);
  filter.group_count = group_count;
  filter.groups_may_touch.assign(may_touch.data(), may_touch.data() + may_touch.size());
}

/// `basis` is 3 n x modes: the three rows of a vertex lie together.
void set_reduced_model(Asking& asking, const PointRows& rest, const Matrix& basis) {
  auto model = std::make_shared<ReducedModel>();
  const auto* first = reinterpret_cast<const Point*>(rest.data());
  model->rest.assign(first, first + rest.shape(0));
  model->modes = static_cast<Index>(basis.shape(1));
  model->basis.assign(basis.data(), basis.data() + basis.size());
  asking.options.paper.reduced_model = std::move(model);
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
  nb::class_<Asking>(module, "Options", nb::type_slots(collected<Asking>))
      .def(nb::init<>())
      .def("choose_method", [](Asking& a, const std::string& name) { choose_method(a.options, name); })
      .def("set_isa", [](Asking& a, const std::string& name) { a.options.isa = isa_from_name(name); })
      .def("set_threads", [](Asking& a, int threads) { a.options.threads = threads; })
      .def("set_min_separation", [](Asking& a, double distance) { a.options.min_separation = distance; })
      .def("set_groups", &set_groups)
      .def("set_thickness", [](Asking& a, std::vector<double> radii) { a.options.thickness = std::move(radii); })
      .def("set_rings", [](Asking& a, int rings) { a.options.filter.rings = rings; })
      .def("set_filter", [](Asking& a, nb::object accepts) { a.accepts = std::move(accepts); })
      .def("set_is_cancelled", [](Asking& a, nb::object is_cancelled) { a.is_cancelled = std::move(is_cancelled); })
      .def(
          "set_bounding_volume",
          [](Asking& a, const std::string& name) { a.options.paper.bounding_volume = bounding_volume_from_name(name); })
      .def("set_paper_filters",
           [](Asking& a, std::vector<std::string> names) { a.options.paper.filters = std::move(names); })
      .def("set_orphan_sets", [](Asking& a, bool on) { a.options.paper.orphan_sets = on; })
      .def("set_representative_triangles", [](Asking& a, bool on) { a.options.paper.representative_triangles = on; })
      .def("set_high_level",
           [](Asking& a, const std::string& name) { a.options.paper.high_level = high_level_from_name(name); })
      .def("set_reduced_model", &set_reduced_model);
  module.def("method_choices", [] { return strings(method_choices()); });
  module.def("filter_names", [] { return strings(filter_names()); });
}

}  // namespace tamis::python

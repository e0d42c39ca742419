#include <nanobind/stl/string.h>

#include <cstddef>

#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"
#include "python/src/layout.hpp"
#include "python/src/pair_results.hpp"
#include "tamis/pair.hpp"

namespace tamis::python {
namespace {

template <int corners>
using Points = std::array<Point, std::size_t{corners}>;
template <int corners>
using Decide = PairResult (*)(const Points<corners>&, const Points<corners>&, const PairOptions&);

template <int corners, Decide<corners> decide>
nb::object decide_all(const PairRows<corners>& start, const PairRows<corners>& end, const std::string& guarantee,
                      double min_separation) {
  const PairOptions options{guarantee_from_name(guarantee), min_separation};
  const auto* starts = reinterpret_cast<const Points<corners>*>(start.data());
  const auto* ends = reinterpret_cast<const Points<corners>*>(end.data());
  return decide_each(start.shape(0), [&](std::size_t i) { return decide(starts[i], ends[i], options); });
}

nb::dict pair_layout() {
  return Layout(sizeof(PairResult))
      .field("touches", "?", offsetof(PairResult, touches))
      .field("certainty", "u1", offsetof(PairResult, certainty))
      .field("toi_lower", "f8", offsetof(PairResult, toi_lower))
      .field("toi_upper", "f8", offsetof(PairResult, toi_upper))
      .field("u", "f8", offsetof(PairResult, u))
      .field("v", "f8", offsetof(PairResult, v))
      .field("normal", "(3,)f8", offsetof(PairResult, normal))
      .dict();
}

}  // namespace

void bind_pairs(nb::module_& module) {
  module.def("vertex_face", &decide_all<4, &vertex_face>);
  module.def("edge_edge", &decide_all<4, &edge_edge>);
  module.def("vertex_edge", &decide_all<3, &vertex_edge>);
  module.def("vertex_vertex", &decide_all<2, &vertex_vertex>);
  module.def("pair_layout", &pair_layout);
}

}  // namespace tamis::python

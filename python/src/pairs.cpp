#include <span>

#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"
#include "python/src/signals.hpp"
#include "tamis/error.hpp"
#include "tamis/pair.hpp"

namespace tamis::python {
namespace {

template <int corners>
std::span<const Point> points_of(const PairRows<corners>& rows) {
  return {reinterpret_cast<const Point*>(rows.data()), std::size_t{corners} * rows.shape(0)};
}

template <PairKind kind, int corners>
nb::object decide_all(const PairRows<corners>& start, const PairRows<corners>& end, double min_separation,
                      double latest) {
  std::vector<PairResult> results(start.shape(0));
  Signals signals;
  const PairListOptions options{min_separation, latest, 0, Isa::best, [&] { return signals.ask(); }};
  signals.begin();
  try {
    const nb::gil_scoped_release unlocked;
    narrow_phase(kind, points_of<corners>(start), points_of<corners>(end), results, options);
  } catch (const Cancelled&) {
    signals.rethrow();
    throw;
  }
  return own_bytes(std::move(results));
}

}  // namespace

void bind_pairs(nb::module_& module) {
  module.def("vertex_face", &decide_all<PairKind::vertex_face, 4>);
  module.def("edge_edge", &decide_all<PairKind::edge_edge, 4>);
  module.def("vertex_edge", &decide_all<PairKind::vertex_edge, 3>);
  module.def("vertex_vertex", &decide_all<PairKind::vertex_vertex, 2>);
}

}  // namespace tamis::python

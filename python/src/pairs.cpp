// The narrow phase of a list of pairs, on straight lines.
#include "python/src/bindings.hpp"
#include "python/src/pair_rows.hpp"
#include "python/src/signals.hpp"
#include "tamis/error.hpp"

namespace tamis::python {
namespace {

nb::object decide_list(const Kinds& kinds, const IndexRowsIn<4>& vertices, const Rows& start, const Rows& end,
                       double min_separation, double latest) {
  std::vector<Pair> pairs(kinds.shape(0));
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i] = pair_at(kinds, vertices, i);
  std::vector<PairResult> results(pairs.size());
  Signals signals;
  const PairListOptions options{min_separation, latest, 0, Isa::best, [&] { return signals.ask(); }};
  signals.begin();
  try {
    const nb::gil_scoped_release unlocked;
    narrow_phase(pairs, {positions(start), positions(end)}, results, options);
  } catch (const Cancelled&) {
    signals.rethrow();
    throw;
  }
  return own_bytes(std::move(results));
}

}  // namespace

void bind_pairs(nb::module_& module) { module.def("narrow_phase", &decide_list); }

}  // namespace tamis::python

// The narrow phase of a list of pairs, on straight lines.
#include <span>

#include "python/src/bindings.hpp"
#include "python/src/pairs/pair_rows.hpp"
#include "python/src/signals.hpp"
#include "tamis/error.hpp"

namespace tamis::python {
namespace {

/// Pairs first to last of those that NumPy has.
void copy_pairs(const Kinds& kinds, const IndexRowsIn<4>& vertices, std::size_t first, std::size_t last,
                std::vector<FeaturePair>& pairs) {
  pairs.resize(last - first);
  for (std::size_t i = first; i < last; ++i) pairs[i - first] = pair_at(kinds, vertices, i);
}

/// In parts that stay in the cache: a copy of the whole list would take a tenth of the time.
void decide_in_parts(const Kinds& kinds, const IndexRowsIn<4>& vertices, const Step& step,
                     std::span<PairResult> results, const PairOptions& options) {
  constexpr std::size_t kPart = 1 << 15;
  std::vector<FeaturePair> pairs;
  std::size_t first = 0;
  try {
    do {
      const std::size_t last = std::min(first + kPart, results.size());
      copy_pairs(kinds, vertices, first, last, pairs);
      narrow_phase(pairs, step, results.subspan(first, last - first), options);
      first = last;
    } while (first < results.size());
  } catch (const InvalidStep&) {
    copy_pairs(kinds, vertices, 0, results.size(), pairs);
    narrow_phase(pairs, step, results, options);  // names the pair by its place in the list
  }
}

nb::object decide_list(const Kinds& kinds, const IndexRowsIn<4>& vertices, const Rows& start, const Rows& end,
                       double min_separation, double latest) {
  std::vector<PairResult> results(kinds.shape(0));
  Signals signals;
  const PairOptions options{
      .min_separation = min_separation, .latest = latest, .is_cancelled = [&] { return signals.ask(); }};
  signals.during([&] { decide_in_parts(kinds, vertices, step_of(start, end), results, options); });
  return own_bytes(std::move(results));
}

}  // namespace

void bind_pairs(nb::module_& module) { module.def("narrow_phase", &decide_list); }

}  // namespace tamis::python

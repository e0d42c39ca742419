#include "engines/brute/step_length.hpp"

#include <algorithm>

#include "engines/cancellation.hpp"
#include "engines/pair_rules.hpp"
#include "engines/stage_counts.hpp"

namespace tamis {
namespace {

/// keep(StepLimit) for every pair.
template <class Keep>
void for_each_limit(const Mesh& mesh, const Options& options, const Step& step, const Separations& separations,
                    double fraction, Statistics& statistics, const Keep& keep) {
  StageCount count{"near"};
  for_each_pair(mesh, options.filter, [&](PairKind kind, const PairVertices& v) {
    stop_if_cancelled(options);
    ++of(count, kind);
    const DistanceRule rule{fraction, separations.between(kind, v)};
    keep(StepLimit{keeps_distance_until(kind, points_of(step, v), rule, 1, statistics.decided_by), kind, v});
  });
  statistics.stages.push_back(count);
}

}  // namespace

SafeStep step_length_by_brute_force(const Mesh& mesh, const Options& options, const Step& step,
                                    const Separations& separations, double fraction, Statistics& statistics) {
  StepLimit limit;
  for_each_limit(mesh, options, step, separations, fraction, statistics,
                 [&](const StepLimit& pair) { limit.add(pair); });
  return limit.answer(step, fraction, separations);
}

void step_ends_by_brute_force(const Mesh& mesh, const Options& options, const Step& step,
                              const Separations& separations, double fraction, std::vector<StepLimit>& ends,
                              Statistics& statistics) {
  ends.clear();
  for_each_limit(mesh, options, step, separations, fraction, statistics, [&](const StepLimit& pair) {
    if (pair.time < 1) ends.push_back(pair);
  });
  std::sort(ends.begin(), ends.end(), comes_before_in_order);
}

}  // namespace tamis

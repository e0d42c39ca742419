#include "engines/brute/step_length.hpp"

#include "engines/cancellation.hpp"
#include "engines/pair_rules.hpp"
#include "engines/stage_counts.hpp"
#include "engines/step_limit.hpp"

namespace tamis {

SafeStep step_length_by_brute_force(const Mesh& mesh, const Options& options, const Step& step,
                                    const Separations& separations, double fraction, Statistics& statistics) {
  StageCount count{"near"};
  StepLimit limit;
  for_each_pair(mesh, options.filter, [&](PairKind kind, const PairVertices& v) {
    stop_if_cancelled(options);
    ++of(count, kind);
    limit.add({keeps_distance_until(kind, points_of(step, v), {fraction, separations.between(kind, v)}, 1,
                                    statistics.decided_by),
               kind, v});
  });
  statistics.stages.push_back(count);
  return limit.answer(step, fraction, separations);
}

}  // namespace tamis

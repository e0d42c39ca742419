// How far may the step go so that every pair keeps a fraction of its distance? A pair can end the step before t only
// if it is fast enough: (1 - fraction) (distance at t=0 - min_separation) < t * relative speed, or what of that is left
// beside a motion that many share; and only if it comes as near as the fraction before t. So the search is for pairs of
// moving boxes that come as near as that, and each pair that ends the step earlier shortens the step for all the rest.
#pragma once
#include <tbb/enumerable_thread_specific.h>

#include <atomic>

#include "bounds/shared_motion.hpp"
#include "engines/tamis/feature_trees.hpp"
#include "engines/tamis/near_pipeline.hpp"
#include "engines/tamis/samples.hpp"

namespace tamis {

class StepLengthSearch {
 public:
  /// Keeps references.
  StepLengthSearch(const Mesh& mesh, const Options& options, const Kernels& kernels, FeatureTrees& trees);

  /// As Engine::find_step_length (docs/numerics.md, "Step lengths").
  SafeStep find(const Step& step, const Separations& separations, double fraction, Statistics& statistics);
  /// As Engine::find_step_ends.
  void find_all(const Step& step, const Separations& separations, double fraction, std::vector<StepLimit>& ends,
                Statistics& statistics);
  std::uint64_t memory_bytes() const;

 private:
  void begin(const Step& step, const Separations& separations, double fraction, bool lists_all, Statistics& statistics);
  void search(const Sample& sample);
  bool meets_many(const Sample& sample) const;
  void search_short_steps(const Samples& samples);
  void search_sample(PairKind kind, const TreeView& a, const TreeView& b, const Sample& sample);
  StepLimit collect(Statistics& statistics, double seconds);

  const Options& options_;
  const Kernels& kernels_;
  FeatureTrees& trees_;
  SharedMotion shared_;
  NearQuestion question_;
  tbb::enumerable_thread_specific<NearPipeline> pipelines_;
};

}  // namespace tamis

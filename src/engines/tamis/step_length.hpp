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

/// Keeps its hierarchy, moving boxes and rests, from step to step. Serves every method but `brute`.
class StepLengthSearch {
 public:
  /// Keeps references: mesh and options must outlive it.
  StepLengthSearch(const Mesh& mesh, const Options& options);

  /// Adds stages, seconds (but `total`), counts and `rebuilt` to `statistics`. Neither threads nor instruction set nor
  /// earlier questions change a bit of the answer (docs/numerics.md, "Step lengths"). REQUIRES: positions of
  /// the mesh's vertices, 0 < fraction < 1. REQUIRES (not checked: O(n)): a validated step. Runs in the caller's oneTBB
  /// arena.
  SafeStep find(const Step& step, const Separations& separations, double fraction, Statistics& statistics);
  /// Every pair that is not proven to keep the fraction during the whole step, by kind, then vertices, with the time
  /// until which it is. Otherwise the same.
  void find_all(const Step& step, const Separations& separations, double fraction, std::vector<StepLimit>& ends,
                Statistics& statistics);
  std::uint64_t memory_bytes() const;

 private:
  void begin(const Step& step, const Separations& separations, double fraction, bool lists_all, Statistics& statistics);
  void search(const Sample& sample);
  bool meets_many(const Sample& sample) const;
  void search_short_steps();
  void search_sample(PairKind kind, const TreeView& a, const TreeView& b, const Sample& sample);
  StepLimit collect(Statistics& statistics, double seconds);

  const Options& options_;
  const Kernels& kernels_;
  FeatureTrees trees_;
  SharedMotion shared_;
  NearQuestion question_;
  tbb::enumerable_thread_specific<NearPipeline> pipelines_;
};

}  // namespace tamis

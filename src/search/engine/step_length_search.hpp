// Conducts safe_step and truncate: finds how far the step may go while every pair keeps a fraction of its distance. A
// pair can end the step before t only if it is fast enough: (1 - fraction) (distance at t=0 - min_separation) < t *
// relative speed, less a motion that many share. It must also come as near as the fraction before t. So the search
// looks for pairs of moving boxes that come as near. Each pair that ends the step earlier shortens it for all others.
// If one start is queried again and again, the pairs near it are listed. Then the list serves the queries.
#pragma once
#include "numbers/held_bytes.hpp"
#include "search/coherence/pairs_near_start.hpp"
#include "search/engine/candidate_search.hpp"
#include "search/engine/step_length_consumer.hpp"
#include "search/engine/thread_streams.hpp"

namespace tamis {

class StepLengthSearch {
 public:
  /// Keeps a reference.
  explicit StepLengthSearch(Workspace& workspace)
      : workspace_(workspace), near_start_(workspace.mesh), streams_(workspace), candidates_(workspace) {}

  /// As Engine::find_step_length (docs/numerics/steps.md, "Step lengths").
  SafeStep find(const Query& query, double fraction, Statistics& statistics);
  /// As Engine::find_step_ends.
  void find_all(const Query& query, double fraction, std::vector<StepLimit>& ends, Statistics& statistics);
  std::uint64_t memory_bytes() const { return held_bytes(near_start_, streams_, candidates_); }

 private:
  /// Searches; the results stay in the consumers.
  void ask(StepLengthQuery& asked, Statistics& statistics);
  bool begin(StepLengthQuery& asked, Statistics& statistics);
  void refit_residuals(StepLengthQuery& asked);
  void search_trees(StepLengthQuery& asked);
  bool meets_many(const Sample& sample) const;
  void search_short_steps(Bound& bound, const Samples& samples);

  Workspace& workspace_;
  PairsNearStart near_start_;
  ThreadStreams<StepLengthConsumer> streams_;
  CandidateSearch candidates_;
};

}  // namespace tamis

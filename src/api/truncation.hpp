// Truncates a step vertex by vertex. All vertices go together until a common time. Up to that time every pair keeps a
// little more of its distance than it must. From there each continues alone. The engine then finds the pairs that do
// not keep their distance on the straight motion to the new positions. Planes between the features of each
// (api/planar_times.hpp) stop its vertices. This repeats in rounds until no such pair is left. If the rounds do not
// end, each vertex goes alone from the start, with planes between all pairs that could meet. All positions that are
// tested are numbers that the caller can store.
#pragma once
#include <atomic>
#include <vector>

#include "api/planar_times.hpp"
#include "search/query/engine.hpp"
#include "tamis/mesh.hpp"

namespace tamis {

class Truncation {
 public:
  /// Keeps references. REQUIRES: as many positions as the mesh has vertices. REQUIRES (not checked: O(n)): a validated
  /// step between positions that can be stored.
  Truncation(const Mesh& mesh, const Query& query, const KeptFractions& fractions, StoredType stored, Engine& engine,
             Statistics& statistics);

  /// `common_time`: until then every pair of the query is proven to keep fractions.together. REQUIRES: in [0,1].
  TruncatedStep run(double common_time);

 private:
  void begin(double common_time);
  /// Lets no vertex continue alone for more than a part of an edge.
  void stop_far_motions();
  void begin_on_own_sides();
  /// Sets the vertex' position in result_ from its fraction of the step.
  void place(Index vertex);
  /// Lets the vertex go no farther than to `time`.
  void stop(Index vertex, double time);
  /// The pairs that break their fraction on the step to result_: their vertices must stop earlier. Pairs that were
  /// tested before and have not changed since are not tested again. Clears result_.is_free if a pair starts within its
  /// separation.
  std::vector<StepLimit> broken_pairs();
  /// True if a vertex of the pair must stop earlier. Sets `some_start_within` if the pair starts within its separation
  /// and is not ignored for that. Several threads may call it. REQUIRES: the pair's time is in [0,1). REQUIRES (not
  /// checked: history): the pair is of the engine's answer.
  bool is_broken(const StepLimit& pair, std::atomic<bool>& some_start_within) const;
  /// True if a vertex of the pair continues after the common time.
  bool goes_on_alone(const StepLimit& pair) const;
  template <class Pair>
  double separation_of(const Pair& pair) const {
    return query_.separations.between(pair.kind, pair.vertices);
  }
  Step step_to_result() const { return {step_.start, result_.positions}; }
  /// Stops each pair's vertices at planes placed at common_time_. If the planes stop none, the vertices go back to that
  /// time.
  void stop_at_planes(const std::vector<StepLimit>& broken);

  const Mesh& mesh_;
  const Query& query_;
  const Step& step_;  ///< the query's step
  const KeptFractions fractions_;
  const StoredType stored_;
  Engine& engine_;
  Statistics& statistics_;
  TruncatedStep result_;               ///< so far
  std::vector<std::uint8_t> changed_;  ///< Query::changed since result_ was last searched; empty if it was not
  double common_time_ = 0;
  bool on_own_sides_ = false;
  int rounds_ = 0;
};

}  // namespace tamis

// A step length for each vertex. All vertices go together as far as every pair keeps a little more of its distance than
// it must; from there each goes on alone. The engine then finds the pairs that do not keep their distance on the
// straight way to these positions, and planes between the features of each (detect/planar_times.hpp) stop its vertices,
// round by round until no pair is left. If that does not end, each vertex goes alone from the start, with planes
// between all pairs that could meet. All positions asked about are numbers that the caller can store.
#pragma once
#include <atomic>
#include <vector>

#include "detect/planar_times.hpp"
#include "query/engine.hpp"
#include "tamis/mesh.hpp"

namespace tamis {

class Truncation {
 public:
  /// Keeps references. REQUIRES: as many positions as the mesh has vertices. REQUIRES (not checked: O(n)): a validated
  /// step between positions that can be stored.
  Truncation(const Mesh& mesh, const Query& query, const KeptFractions& fractions, Stored stored, Engine& engine,
             Statistics& statistics);

  /// `together`: until then it is proven that every pair of the query keeps fractions.together. REQUIRES: in [0,1].
  TruncatedStep run(double together);

 private:
  void begin(double together);
  void begin_on_own_sides();
  void place(Index vertex);
  void stop(Index vertex, double time);
  /// Asks about way(): those pairs whose vertices must go less far. Pairs that were asked about and have not changed
  /// since are not asked again. Says in to_ if the step is not free, as far as that shows.
  std::vector<StepLimit> broken_pairs();
  /// Sets `some_start_within` if it starts within its separation. Several threads may ask. REQUIRES: a time in [0,1).
  /// REQUIRES (not checked: history): a pair of the engine's answer.
  bool is_broken(const StepLimit& pair, std::atomic<bool>& some_start_within) const;
  bool is_beyond(const StepLimit& pair) const;
  template <class Pair>
  double separation_of(const Pair& pair) const {
    return query_.separations.between(pair.kind, pair.vertices);
  }
  Step way() const { return {step_.start, to_.positions}; }
  void stop_at_planes(const StepLimit& pair, const std::vector<double>& asked);

  const Mesh& mesh_;
  const Query& query_;
  const Step& step_;  ///< that of the query
  const KeptFractions fractions_;
  const Stored stored_;
  Engine& engine_;
  Statistics& statistics_;
  TruncatedStep to_;
  std::vector<std::uint8_t> changed_;  ///< as Query::changed, since way() was asked about; empty: it was not
  double together_ = 0;
  bool on_own_sides_ = false;
  int rounds_ = 0;
};

}  // namespace tamis

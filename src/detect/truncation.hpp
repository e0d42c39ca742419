// A step length for each vertex. All vertices go together as far as every pair keeps a little more of its distance than
// it must; from there each goes on alone. The engine then finds the pairs that do not keep their distance on the
// straight way to these positions, and planes between the features of each (detect/planar_times.hpp) stop its vertices,
// round by round until no pair is left. If that does not end, each vertex goes alone from the start, with planes
// between all pairs that could meet. All positions asked about are numbers that the caller can store.
#pragma once
#include <vector>

#include "detect/planar_times.hpp"
#include "motion/separations.hpp"
#include "query/step_limit.hpp"
#include "tamis/mesh.hpp"

namespace tamis {

class Truncation {
 public:
  /// Until `together` it is proven that every pair of the query keeps fractions.together. Keeps references. REQUIRES:
  /// as many positions as the mesh has vertices, 0 <= together <= 1. REQUIRES (not checked: O(n)): a validated step
  /// between positions that can be stored.
  Truncation(const Mesh& mesh, const Query& query, const KeptFractions& fractions, double together, Stored stored);

  /// The way to be proven next: the engine is asked for all pairs that do not keep their fraction on it.
  Step way() const { return {step_.start, to_.positions}; }
  enum class Next : std::uint8_t {
    done,        ///< the way is proven
    ask,         ///< of another way
    plan_apart,  ///< the same, after keep_apart() of what is near at the start within reach()
  };
  /// `ends`: the engine's answer about way().
  Next after(const std::vector<StepLimit>& ends);

  Separations reach() const { return {separations_.fixed, radii_}; }
  void keep_apart(const std::vector<NearPair>& near);

  TruncatedStep take() { return std::move(to_); }

 private:
  void begin(double together);
  void begin_apart();
  void place(Index vertex);
  void stop(Index vertex, double time);
  /// Must the pair's vertices go less far? REQUIRES: a time in [0,1). REQUIRES (not checked: history): a pair of the
  /// engine's answer.
  bool is_broken(const StepLimit& pair);
  bool is_beyond(const StepLimit& pair) const;
  double separation_of(const StepLimit& pair) const { return separations_.between(pair.kind, pair.vertices); }
  void stop_at_planes(const StepLimit& pair, const std::vector<double>& asked);

  const Mesh& mesh_;
  const Step& step_;
  const Separations& separations_;
  const bool ignores_start_;
  const KeptFractions fractions_;
  const Stored stored_;
  TruncatedStep to_;
  double together_ = 0;
  bool is_apart_ = false;
  int rounds_ = 0;
  std::vector<double> radii_;  ///< how far each vertex reaches from the start, and its features' own radius
};

}  // namespace tamis

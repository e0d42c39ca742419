// The pair that ends the step first, the same in whatever order pairs are added.
#pragma once
#include <tuple>

#include "numbers/assert.hpp"
#include "pair/narrow/near_pair.hpp"
#include "search/query/pair_vertices.hpp"
#include "search/query/query.hpp"
#include "tamis/step_length.hpp"

namespace tamis {

/// A pair that ends the step, and when.
struct StepLimit {
  double time = 1;  ///< 1: no pair ends the step
  PairKind kind = PairKind::vertex_face;
  PairVertices vertices{};

  /// Keeps the earlier of both. Of equal times it keeps the first in the order of contacts.
  void add(const StepLimit& other) {
    TAMIS_ASSERT(0 <= other.time && other.time <= 1);
    if (other.time < 1 && other.key() < key()) *this = other;
  }

  /// True if it is certain that no pair of the other kind with these vertices (by default: with any) ends the step
  /// first. It is if this pair ends the step at t=0, and comes before that one in the order of contacts.
  bool rules_out(PairKind other_kind, const PairVertices& others = {}) const {
    return time == 0 && key() < StepLimit{0, other_kind, others}.key();
  }

  /// The answer to safe_step: this pair's time, a time when it is proven to have ended the step, and the pair at t=0.
  SafeStep answer(const Query& query, double fraction) const {
    if (time == 1) return {};
    const DistanceRule rule = query.distance_rule_for(kind, vertices, fraction);
    const PairPoints points = points_of(query.step, vertices);
    return {time, fraction_is_left_at(kind, points, rule, time), near_pair(kind, vertices, points)};
  }

 private:
  std::tuple<double, PairKind, PairVertices> key() const { return {time, kind, vertices}; }
};

/// By kind, then vertices, whatever their times: the order of contacts.
inline bool comes_before_in_order(const StepLimit& a, const StepLimit& b) {
  return std::tie(a.kind, a.vertices) < std::tie(b.kind, b.vertices);
}

}  // namespace tamis

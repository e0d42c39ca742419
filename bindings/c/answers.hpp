// Converts answers of a detector and of a world to C's structs.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "tamis/statistics.hpp"
#include "tamis/tamis.h"

namespace tamis::c {

/// Writes the two bodies of a world's answer; -1 for a detector's.
template <class Answer>
void write_bodies(const Answer& answer, int32_t* bodies) {
  if constexpr (requires { answer.bodies; })
    std::copy(answer.bodies.begin(), answer.bodies.end(), bodies);
  else
    std::fill_n(bodies, 2, -1);
}

/// From a Contact or a BodyContact; the functions below likewise.
template <class AnyContact>
tamis_contact contact_of(const AnyContact& c) {
  tamis_contact contact{
      static_cast<int32_t>(c.kind), static_cast<int32_t>(c.certainty), {}, c.toi_lower, c.toi_upper, c.u, c.v, {}, {}};
  std::copy(c.vertices.begin(), c.vertices.end(), contact.vertices);
  std::copy(c.normal.begin(), c.normal.end(), contact.normal);
  write_bodies(c, contact.bodies);
  return contact;
}

template <class AnyNearPair>
tamis_near_pair near_pair_of(const AnyNearPair& n) {
  tamis_near_pair pair{static_cast<int32_t>(n.kind), {}, n.distance, n.u, n.v, {}, {}};
  std::copy(n.vertices.begin(), n.vertices.end(), pair.vertices);
  std::copy(n.direction.begin(), n.direction.end(), pair.direction);
  write_bodies(n, pair.bodies);
  return pair;
}

template <class AnyIntersection>
tamis_intersection intersection_of(const AnyIntersection& i) {
  tamis_intersection result{{}, {}, i.s_lower, i.s_upper, i.u, i.v, {}};
  std::copy(i.edge.begin(), i.edge.end(), result.edge);
  std::copy(i.face.begin(), i.face.end(), result.face);
  write_bodies(i, result.bodies);
  return result;
}

/// From a SafeStep or a BodyStep.
template <class AnySafeStep>
tamis_safe_step answer_of(const AnySafeStep& safe) {
  tamis_safe_step answer{};
  answer.toi_lower = safe.toi_lower;
  answer.toi_upper = safe.toi_upper;
  answer.has_pair = safe.pair.has_value();
  if (safe.pair) answer.pair = near_pair_of(*safe.pair);
  return answer;
}

/// `names` keeps the names of the stages.
tamis_statistics statistics_of(const Statistics& s, std::vector<std::string>& names);

}  // namespace tamis::c

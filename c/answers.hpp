// Answers as C has them that more than one handle gives.
#pragma once
#include <algorithm>

#include "tamis/proximity.hpp"
#include "tamis/tamis.h"

namespace tamis::c {

inline tamis_safe_step answer_of(const SafeStep& safe) {
  tamis_safe_step answer{};
  answer.lower = safe.lower;
  answer.upper = safe.upper;
  if (!safe.pair) return answer;
  answer.has_pair = 1;
  answer.kind = static_cast<int32_t>(safe.pair->kind);
  std::copy(safe.pair->vertices.begin(), safe.pair->vertices.end(), answer.vertices);
  answer.distance = safe.pair->distance;
  return answer;
}

inline tamis_near_pair near_pair_of(const NearPair& n) {
  tamis_near_pair pair{static_cast<int32_t>(n.kind), n.corners, {}, n.distance, n.u, n.v, {}};
  std::copy(n.vertices.begin(), n.vertices.end(), pair.vertices);
  std::copy(n.direction.begin(), n.direction.end(), pair.direction);
  return pair;
}

}  // namespace tamis::c

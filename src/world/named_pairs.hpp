// Pairs of bodies' features as a world's answers have them: named by bodies and own vertices, and in one order.
#pragma once
#include "query/pair_rules.hpp"
#include "tamis/world.hpp"

namespace tamis {

/// By kind, then body and own vertex of all four.
template <class Pair>
bool is_before(const Pair& a, const Pair& b) {
  if (a.kind != b.kind) return a.kind < b.kind;
  const std::size_t second = second_feature(a.kind);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t body = i < second ? 0 : 1;
    if (a.bodies[body] != b.bodies[body]) return a.bodies[body] < b.bodies[body];
    if (a.vertices[i] != b.vertices[i]) return a.vertices[i] < b.vertices[i];
  }
  return false;
}

inline std::array<BodyId, 2> twice(BodyId body) { return {body, body}; }

}  // namespace tamis

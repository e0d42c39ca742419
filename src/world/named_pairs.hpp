// Pairs of bodies' features as a world's answers have them: named by bodies and own vertices, and in one order.
#pragma once
#include <optional>
#include <tuple>

#include "query/pair_rules.hpp"
#include "world/gathered.hpp"

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
inline bool is_before(const BodyIntersection& a, const BodyIntersection& b) {
  return std::tie(a.bodies[0], a.edge, a.bodies[1], a.face) < std::tie(b.bodies[0], b.edge, b.bodies[1], b.face);
}

/// What a detector says of a pair, as a `Row` of an answer: of a body by itself, or of what is gathered.
template <class Row, class Pair>
Row named(const Pair& pair, BodyId itself) {
  return {pair, {itself, itself}};
}
template <class Row, class Pair>
Row named(const Pair& pair, const Gathered& gathered) {
  return gathered.named<Row>(pair);
}

/// Keeps the first of what several detectors say, `other` of `whose`; of two at one time the one that is before.
template <class Row, class Pair, class Whose>
void take_sooner(std::optional<Row>& first, double& time, const std::optional<Pair>& other, double other_time,
                 const Whose& whose) {
  if (!other || other_time > time) return;
  const Row row = named<Row>(*other, whose);
  if (first && other_time == time && !is_before(row, *first)) return;
  time = other_time;
  first = row;
}

}  // namespace tamis

// Merges the answers of a world's detectors into one order, and names pairs by bodies and the bodies' own vertices.
#pragma once
#include <algorithm>
#include <optional>
#include <tuple>
#include <vector>

#include "search/query/pair_vertices.hpp"
#include "worlds/gathered.hpp"

namespace tamis {

/// Compares by kind, then by body and own vertex of each of the four vertices.
template <class Row>
bool is_before(const Row& a, const Row& b) {
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

/// A pair of a detector as a `Row` of the world's answer: of a body with itself, or of a gathered mesh.
template <class Row, class Pair>
Row named(const Pair& pair, BodyId itself) {
  return {pair, {itself, itself}};
}
template <class Row, class Pair>
Row named(const Pair& pair, const Gathered& gathered) {
  Row row{pair, {}};
  gathered.name(row);
  return row;
}

/// Keeps the earliest pair of several detectors in `first` and `time`. Of two pairs at one time the first by
/// is_before(). `other` is of `whose` mesh.
template <class Row, class Pair, class Whose>
void keep_earlier(std::optional<Row>& first, double& time, const std::optional<Pair>& other, double other_time,
                  const Whose& whose) {
  if (!other || other_time > time) return;
  const Row row = named<Row>(*other, whose);
  if (first && other_time == time && !is_before(row, *first)) return;
  time = other_time;
  first = row;
}

/// Adds the answer of one detector, of `whose` mesh.
template <class Row, class Pair, class Whose>
void add_named(std::vector<Row>& rows, const std::vector<Pair>& pairs, const Whose& whose) {
  rows.reserve(rows.size() + pairs.size());
  for (const Pair& pair : pairs) rows.push_back(named<Row>(pair, whose));
}

/// Puts the answers of several detectors in one order. Each detector's answers are in order. Equal rows, of duplicate
/// features, stay in the order of their times, as a detector gives them.
template <class Row>
void put_in_order(std::vector<Row>& rows) {
  const auto is_row_before = [](const Row& a, const Row& b) { return is_before(a, b); };
  if (!std::ranges::is_sorted(rows, is_row_before)) std::ranges::stable_sort(rows, is_row_before);
}

}  // namespace tamis

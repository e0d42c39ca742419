// The pairs of bodies that each have a first contact of their own (Query::each_of).
#pragma once
#include <algorithm>
#include <utility>

#include "numbers/assert.hpp"
#include "numbers/held_bytes.hpp"
#include "search/topology/rows.hpp"

namespace tamis {

/// Some pairs of the bodies whose vertices make up a mesh. The pairs have the numbers 0, 1, 2, ...
class BodyPairs {
 public:
  /// `body_of_vertex`: a number in [0, body_count) for each vertex. REQUIRES (not checked: O(n)): `pairs` ascend, each
  /// pair once, its smaller body first.
  BodyPairs(Index body_count, std::vector<Index> body_of_vertex, const std::vector<std::array<Index, 2>>& pairs)
      : body_of_vertex_(std::move(body_of_vertex)), partners_(rows_of(body_count, [&](const auto& add) {
          for (const auto& [first, second] : pairs) add(first, second);
        })) {}

  std::size_t count() const { return partners_.items.size(); }
  /// The number of the pair of the bodies of two vertices; count() if it is not one of the pairs. REQUIRES: vertices of
  /// the mesh.
  std::size_t number_of(Index a, Index b) const {
    TAMIS_ASSERT(at(a) < body_of_vertex_.size() && at(b) < body_of_vertex_.size());
    const auto [first, second] = std::minmax(body_of_vertex_[at(a)], body_of_vertex_[at(b)]);
    const auto all = partners_.items.begin();
    const auto begin = all + partners_.offsets[at(first)], end = all + partners_.offsets[at(first) + 1];
    const auto found = std::lower_bound(begin, end, second);
    return found != end && *found == second ? static_cast<std::size_t>(found - all) : count();
  }
  std::uint64_t memory_bytes() const { return held_bytes(body_of_vertex_, partners_.offsets, partners_.items); }

 private:
  std::vector<Index> body_of_vertex_;
  IndexRows partners_;  ///< for each body the greater bodies of its pairs, ascending
};

}  // namespace tamis

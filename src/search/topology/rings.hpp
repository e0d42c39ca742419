// Rings: the number of edges between two features. Pairs fewer edges apart than the caller wants are skipped.
#pragma once
#include <span>

#include "numbers/held_bytes.hpp"
#include "search/topology/rows.hpp"
#include "tamis/mesh.hpp"

namespace tamis {

class Rings {
 public:
  /// Features with fewer than `rings` edges between them are neighbours. For one ring, where these are features with a
  /// common vertex, nothing is stored. REQUIRES: rings >= 1.
  Rings(const Mesh& mesh, int rings);

  /// True if there is more than one ring. If not, only features with a common vertex are neighbours.
  bool any() const { return rings_ > 1; }
  /// True if the shortest way along edges, from a vertex of one feature to a vertex of the other, is shorter than
  /// `rings` > 1. Grows rings around both, each time the one with fewer edges. REQUIRES: vertices of the mesh.
  bool are_neighbours(std::span<const Index> first, std::span<const Index> second) const {
    return any() && search(first, second);
  }

  std::uint64_t memory_bytes() const { return held_bytes(next_to_.offsets, next_to_.items); }

 private:
  bool search(std::span<const Index> first, std::span<const Index> second) const;

  int rings_;
  IndexRows next_to_;  ///< for each vertex, its neighbours along edges
};

}  // namespace tamis

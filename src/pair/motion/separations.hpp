// Features within this distance count as touching. It is a distance for all pairs plus a radius for each of the two
// features.
#pragma once
#include <algorithm>
#include <array>
#include <span>

#include "numbers/assert.hpp"
#include "pair/motion/pair_kinds.hpp"

namespace tamis {

/// In the unit of the positions, finite and >= 0. Refers to the radii, which must outlive it.
struct Separations {
  double fixed = 0;
  std::span<const double> radii = {};  ///< one a vertex of the mesh; empty: all zero

  /// True if there is any separation. If not, contact means touching.
  bool any() const { return fixed > 0 || !radii.empty(); }
  /// The separation of one pair: a feature has the largest radius of its vertices. `v` as in Contact. REQUIRES: a
  /// radius for each vertex of `v`, or none at all.
  double between(PairKind kind, const std::array<Index, 4>& v) const {
    if (radii.empty()) return fixed;
    const std::size_t second = second_feature(kind);
    return (largest(v, 0, second) + largest(v, second, vertex_count(kind))) + fixed;
  }
  /// The largest radius of all vertices.
  double largest_radius() const { return radii.empty() ? 0 : *std::max_element(radii.begin(), radii.end()); }

 private:
  double largest(const std::array<Index, 4>& v, std::size_t first, std::size_t last) const {
    double radius = 0;
    for (std::size_t i = first; i < last; ++i) {
      TAMIS_ASSERT(static_cast<std::size_t>(v[i]) < radii.size());
      radius = std::max(radius, radii[static_cast<std::size_t>(v[i])]);
    }
    return radius;
  }
};

}  // namespace tamis

// Elements of the mesh with all that a search among them needs: triangles, loose edges and loose points, each with its
// edges and corners. So a feature never comes without the element to which it belongs.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "distributed/src/bytes.hpp"
#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis::distributed {

/// A vertex of the whole mesh.
struct Vertex {
  Index number;
  Index group;  ///< of the pair filter
  int home;     ///< the lowest rank that gives its position; a contact goes to the home of its first vertex

  friend bool operator==(const Vertex&, const Vertex&) = default;
};

/// The place of the row with this number, or where it would be. REQUIRES (not checked: O(n)): rows sorted by `number`.
template <class Row>
std::size_t place_of(const std::vector<Row>& rows, Index number) {
  return static_cast<std::size_t>(std::ranges::lower_bound(rows, number, {}, &Row::number) - rows.begin());
}

/// Where a vertex is at t=0 and t=1.
struct Motion {
  Point start, end;
};

/// The vertices of a triangle (in its winding), a loose edge or a loose point; unused entries are -1.
using Corners = std::array<Index, 3>;
/// Made from the rank that owns an element, and the element's place there.
using ElementId = std::uint64_t;

inline ElementId element_id(int rank, std::size_t place) {
  constexpr int kPlaceBits = 32;
  return static_cast<ElementId>(rank) << kPlaceBits | place;
}

struct ElementSet {
  std::vector<Vertex> vertices;   ///< by number
  std::vector<Motion> motions;    ///< one a vertex, or none if the set is only topology
  std::vector<Corners> elements;  ///< places in `vertices`
  std::vector<ElementId> ids;     ///< one an element, or none before it has an owner

  bool empty() const { return elements.empty(); }
};

/// Calls f(place) for each corner of an element.
template <class F>
void for_each_corner(const Corners& corners, const F& f) {
  for (const Index corner : corners)
    if (corner >= 0) f(static_cast<std::size_t>(corner));
}

/// The elements at `places` with their vertices.
ElementSet subset(const ElementSet& set, std::span<const std::uint32_t> places);
/// Every element and every vertex of any of the sets, once. REQUIRES: ids, motions.
ElementSet united(std::span<const ElementSet* const> sets);
/// Copies the motions of all vertices of `from`. REQUIRES: `to` has each of these vertices.
void copy_motions(const ElementSet& from, ElementSet& to);

void pack(Packer& packer, const ElementSet& set);
ElementSet unpack_elements(Unpacker& unpacker);

}  // namespace tamis::distributed

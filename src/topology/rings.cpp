#include "topology/rings.hpp"

#include <algorithm>

#include "numerics/assert.hpp"
#include "topology/at.hpp"

namespace tamis {
namespace {

IndexRows neighbours_of_vertices(const Mesh& mesh) {
  IndexRows rows;
  rows.offsets.assign(at(mesh.vertex_count()) + 1, 0);
  for (const Edge& edge : mesh.edges())
    for (const Index v : edge) ++rows.offsets[at(v) + 1];
  for (std::size_t v = 0; v < at(mesh.vertex_count()); ++v) rows.offsets[v + 1] += rows.offsets[v];
  rows.items.resize(at(rows.offsets.back()));
  std::vector<Index> place(rows.offsets.begin(), rows.offsets.end() - 1);
  for (const auto& [a, b] : mesh.edges()) {
    rows.items[at(place[at(a)]++)] = b;
    rows.items[at(place[at(b)]++)] = a;
  }
  return rows;
}

void sort_once_each(std::vector<Index>& vertices) {
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
}

bool share(std::span<const Index> sorted, std::span<const Index> vertices) {
  return std::any_of(vertices.begin(), vertices.end(),
                     [&](Index v) { return std::binary_search(sorted.begin(), sorted.end(), v); });
}

}  // namespace

Rings::Rings(const Mesh& mesh, int rings) : rings_(rings) {
  TAMIS_ASSERT(rings >= 1);
  if (any()) next_to_ = neighbours_of_vertices(mesh);
}

bool Rings::search(std::span<const Index> first, std::span<const Index> second) const {
  // A neighbour of a ring is in that ring, in the one before it, or in the next.
  std::vector<Index> before, ring(first.begin(), first.end()), next;
  sort_once_each(ring);
  for (int distance = 0; !share(ring, second); before.swap(ring), ring.swap(next)) {
    if (++distance == rings_ || ring.empty()) return false;
    next.clear();
    for (const Index v : ring)
      for (const Index w : next_to_[v])
        if (!std::binary_search(before.begin(), before.end(), w) && !std::binary_search(ring.begin(), ring.end(), w))
          next.push_back(w);
    sort_once_each(next);
  }
  return true;
}

}  // namespace tamis

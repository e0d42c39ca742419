#include "topology/rings.hpp"

#include <algorithm>

#include "numerics/assert.hpp"
#include "tamis/components.hpp"

namespace tamis {
namespace {

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
  if (any()) next_to_ = neighbours_of(mesh);
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

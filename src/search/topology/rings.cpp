#include "search/topology/rings.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

#include "numbers/assert.hpp"
#include "search/topology/neighbours.hpp"

namespace tamis {
namespace {

/// The vertices at some number of edges from a feature, and `before`, those one edge nearer.
struct Ring {
  explicit Ring(std::span<const Index> feature) : vertices(feature.begin(), feature.end()) { sort_once_each(); }

  void sort_once_each() {
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  }
  bool has(Index v) const { return std::binary_search(vertices.begin(), vertices.end(), v); }
  std::size_t neighbour_count(const IndexRows& next_to) const {
    return std::transform_reduce(vertices.begin(), vertices.end(), std::size_t{0}, std::plus(),
                                 [&](Index v) { return next_to[v].size(); });
  }
  /// Moves to the next ring. A neighbour of a ring is in that ring, in the one before it, or in the next.
  void grow(const IndexRows& next_to) {
    Ring next({});
    for (const Index v : vertices)
      for (const Index w : next_to[v])
        if (!has(w) && !std::binary_search(before.begin(), before.end(), w)) next.vertices.push_back(w);
    next.sort_once_each();
    next.before = std::move(vertices);
    *this = std::move(next);
  }

  std::vector<Index> vertices, before;
};

}  // namespace

Rings::Rings(const Mesh& mesh, int rings) : rings_(rings) {
  TAMIS_ASSERT(rings >= 1);
  if (any()) next_to_ = neighbours_of(mesh);
}

bool Rings::search(std::span<const Index> first, std::span<const Index> second) const {
  Ring near(first), far(second);
  if (std::any_of(second.begin(), second.end(), [&](Index v) { return near.has(v); })) return true;
  for (int distance = 1;; ++distance) {
    if (far.neighbour_count(next_to_) < near.neighbour_count(next_to_)) std::swap(near, far);
    for (const Index v : near.vertices)
      for (const Index w : next_to_[v])
        if (far.has(w)) return true;
    if (distance + 1 >= rings_ || near.vertices.empty()) return false;
    near.grow(next_to_);
  }
}

}  // namespace tamis

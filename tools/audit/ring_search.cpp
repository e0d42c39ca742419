#include "audit/ring_search.hpp"

#include <algorithm>

namespace tamis::audit {
namespace {

constexpr Index kUnreached = -1;

}  // namespace

RingSearch::RingSearch(const AuditedMesh& mesh, Index limit)
    : mesh_(mesh), limit_(limit), rings_(static_cast<std::size_t>(mesh.mesh().vertex_count()), kUnreached) {}

Index RingSearch::between(std::span<const Index> first, std::span<const Index> second) {
  if (!mesh_.are_connected(first.front(), second.front())) return kNotConnected;
  if (!std::equal(first.begin(), first.end(), from_.begin(), from_.end())) search_from(first);
  Index nearest = limit_ + 1;
  for (const Index v : second) nearest = std::min(nearest, rings_to(v));
  return nearest;
}

void RingSearch::search_from(std::span<const Index> feature) {
  for (const Index v : reached_) rings_[static_cast<std::size_t>(v)] = kUnreached;
  reached_.clear();
  from_.assign(feature.begin(), feature.end());
  for (const Index v : feature) reach(v, 0);
  // By index, as reach() makes the list longer.
  for (std::size_t i = 0; i < reached_.size(); ++i) {  // NOLINT(modernize-loop-convert)
    const Index rings = rings_[static_cast<std::size_t>(reached_[i])] + 1;
    if (rings > limit_) return;
    for (const Index v : mesh_.neighbours()[static_cast<std::size_t>(reached_[i])]) reach(v, rings);
  }
}

void RingSearch::reach(Index vertex, Index rings) {
  Index& known = rings_[static_cast<std::size_t>(vertex)];
  if (known != kUnreached) return;
  known = rings;
  reached_.push_back(vertex);
}

Index RingSearch::rings_to(Index vertex) const {
  const Index rings = rings_[static_cast<std::size_t>(vertex)];
  return rings == kUnreached ? limit_ + 1 : rings;
}

}  // namespace tamis::audit

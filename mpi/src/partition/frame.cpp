#include "mpi/src/partition/frame.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace tamis::distributed {
namespace {

constexpr std::size_t kSides = 6;
constexpr std::size_t kMost = 64;  ///< elements that one rank lends at a time

/// How far an element reaches to each of six sides; a smaller number reaches farther.
std::array<double, kSides> reach_of(const ElementSet& set, const Corners& corners) {
  std::array<double, kSides> reach;
  reach.fill(std::numeric_limits<double>::infinity());
  for_each_corner(corners, [&](std::size_t v) {
    for (const Point& p : {set.motions[v].start, set.motions[v].end})
      for (std::size_t axis = 0; axis < 3; ++axis) {
        reach[axis] = std::min(reach[axis], p[axis]);
        reach[3 + axis] = std::min(reach[3 + axis], -p[axis]);
      }
  });
  return reach;
}

}  // namespace

void Frame::choose(const ElementSet& own) {
  std::array<double, kSides> farthest;
  farthest.fill(std::numeric_limits<double>::infinity());
  std::array<std::uint32_t, kSides> place{};
  for (std::size_t e = 0; e < own.elements.size(); ++e) {
    const auto reach = reach_of(own, own.elements[e]);
    for (std::size_t side = 0; side < kSides; ++side)
      if (reach[side] < farthest[side]) farthest[side] = reach[side], place[side] = static_cast<std::uint32_t>(e);
  }
  std::array<double, kSides> of_all = farthest;
  communicator_.reduce_to_least(of_all);
  std::array<int, kSides> rank{};
  for (std::size_t side = 0; side < kSides; ++side)
    rank[side] = !own.empty() && farthest[side] == of_all[side] ? communicator_.rank() : communicator_.size();
  communicator_.reduce_to_least(rank);
  if (lent_.size() > kMost) lent_.clear();
  for (std::size_t side = 0; side < kSides; ++side)
    if (rank[side] == communicator_.rank()) lent_.insert(place[side]);
}

ElementSet Frame::span(const ElementSet& own) {
  choose(own);
  Packer packer;
  if (!lent_.empty()) pack(packer, subset(own, std::vector<std::uint32_t>(lent_.begin(), lent_.end())));
  std::vector<ElementSet> sets;
  for (const Bytes& bytes : communicator_.gather_for_all(packer.take())) {
    if (bytes.empty()) continue;
    Unpacker unpacker(bytes);
    sets.push_back(unpack_elements(unpacker));
  }
  std::vector<const ElementSet*> all;
  for (const ElementSet& set : sets) all.push_back(&set);
  return united(all);
}

}  // namespace tamis::distributed

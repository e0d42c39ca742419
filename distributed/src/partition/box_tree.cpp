#include "distributed/src/partition/box_tree.hpp"

namespace tamis::distributed {

BoxTree::BoxTree(std::vector<MovingBox> leaves) : levels_{std::move(leaves)} {
  while (levels_.back().size() > 1) {
    const std::vector<MovingBox>& below = levels_.back();
    std::vector<MovingBox> level((below.size() + kChildren - 1) / kChildren);
    for (std::size_t node = 0; node < below.size(); ++node) level[node / kChildren].include(below[node]);
    levels_.push_back(std::move(level));
  }
}

const std::vector<MovingBox>& BoxTree::level_of_at_most(std::size_t most) const {
  return *std::ranges::find_if(levels_, [most](const auto& level) { return level.size() <= most; });
}

BoxTree::Nodes BoxTree::children(std::size_t level, const Nodes& nodes) const {
  const auto count = static_cast<std::uint32_t>(levels_[level - 1].size());
  constexpr auto kEach = static_cast<std::uint32_t>(kChildren);
  Nodes result;
  for (const std::uint32_t node : nodes)
    for (std::uint32_t child = node * kEach; child < std::min((node + 1) * kEach, count); ++child)
      result.push_back(child);
  return result;
}

}  // namespace tamis::distributed

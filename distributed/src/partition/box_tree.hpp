// A tree over boxes in spatial order: each node has sixteen children that stand side by side.
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "distributed/src/partition/moving_box.hpp"

namespace tamis::distributed {

class BoxTree {
 public:
  static constexpr std::size_t kChildren = 16;

  explicit BoxTree(std::vector<MovingBox> leaves = {});

  const MovingBox& root() const { return levels_.back().front(); }
  bool empty() const { return levels_.front().empty(); }
  /// The lowest level that has no more than `most` boxes.
  const std::vector<MovingBox>& level_of_at_most(std::size_t most) const;
  /// Leaves of this tree, ascending, that `may_matter` to some leaf of `other`.
  template <class Test>
  std::vector<std::uint32_t> leaves_that_meet(const BoxTree& other, const Test& may_matter) const;

 private:
  using Nodes = std::vector<std::uint32_t>;

  template <class Test>
  void visit(std::size_t level, std::uint32_t node, const BoxTree& other, std::size_t other_level, const Nodes& others,
             const Test& may_matter, Nodes& found) const;
  Nodes children(std::size_t level, const Nodes& nodes) const;

  std::vector<std::vector<MovingBox>> levels_;  ///< the leaves first, the root alone last
};

template <class Test>
std::vector<std::uint32_t> BoxTree::leaves_that_meet(const BoxTree& other, const Test& may_matter) const {
  Nodes found;
  if (!empty() && !other.empty()) visit(levels_.size() - 1, 0, other, other.levels_.size() - 1, {0}, may_matter, found);
  return found;
}

/// Goes on with those of `others` that may matter to `node`: both sides go down one level, until both are leaves.
template <class Test>
void BoxTree::visit(std::size_t level, std::uint32_t node, const BoxTree& other, std::size_t other_level,
                    const Nodes& others, const Test& may_matter, Nodes& found) const {
  const bool is_leaf = level == 0 && other_level == 0;
  Nodes met;
  for (const std::uint32_t theirs : others) {
    if (!may_matter(levels_[level][node], other.levels_[other_level][theirs])) continue;
    if (is_leaf) return found.push_back(node);
    met.push_back(theirs);
  }
  if (met.empty()) return;
  if (other_level > 0) met = other.children(other_level--, met);
  if (level == 0) return visit(0, node, other, other_level, met, may_matter, found);
  for (const std::uint32_t child : children(level, {node}))
    visit(level - 1, child, other, other_level, met, may_matter, found);
}

}  // namespace tamis::distributed

// Self traversal of a binary hierarchy: every pair of different triangles whose bounds overlap, once.
#pragma once
#include <cstdint>
#include <deque>
#include <vector>

#include "paper/bvh/binary_tree.hpp"

namespace tamis::lab {

/// A part of the traversal: pairs between two subtrees, or within one if a == b.
struct SubtreePair {
  Index a, b;
};

template <class Volume>
class SelfTraversal {
 public:
  /// `free_within`: for each node, whether to leave out its inner pairs; or empty.
  SelfTraversal(const BinaryTree& tree, const std::vector<Volume>& volumes, std::span<const std::uint8_t> free_within)
      : tree_(tree), volumes_(volumes), free_within_(free_within) {}

  /// Splits the traversal into disjoint parts: `wanted` or a few more, fewer if the tree is small.
  std::vector<SubtreePair> parts(std::size_t wanted) const {
    std::deque<SubtreePair> open;
    std::vector<SubtreePair> done;
    if (tree_.size() > 1) open.push_back({0, 0});
    while (!open.empty() && open.size() + done.size() < wanted) {
      const SubtreePair part = open.front();
      open.pop_front();
      if (is_free_within(part)) continue;
      if (part.a != part.b && (tree_.is_leaf(part.a) || tree_.is_leaf(part.b)))
        done.push_back(part);
      else
        split(part, [&](Index a, Index b) { open.push_back({a, b}); });
    }
    done.insert(done.end(), open.begin(), open.end());
    return done;
  }

  /// Calls on_pair(triangle, triangle) for the pairs of the part; adds the number of overlap tests to `tested`.
  template <class OnPair>
  void visit(const SubtreePair& part, const OnPair& on_pair, std::uint64_t& tested) const {
    if (is_free_within(part)) return;
    if (part.a == part.b) {
      if (!tree_.is_leaf(part.a)) split(part, [&](Index a, Index b) { visit({a, b}, on_pair, tested); });
      return;
    }
    ++tested;
    if (!overlap(volume(part.a), volume(part.b))) return;
    if (tree_.is_leaf(part.a) && tree_.is_leaf(part.b))
      on_pair(tree_.triangle(part.a), tree_.triangle(part.b));
    else
      split(part, [&](Index a, Index b) { visit({a, b}, on_pair, tested); });
  }

 private:
  bool is_free_within(const SubtreePair& part) const {
    return part.a == part.b && !free_within_.empty() && free_within_[static_cast<std::size_t>(part.a)];
  }

  const Volume& volume(Index node) const { return volumes_[static_cast<std::size_t>(node)]; }

  /// Opens both nodes at once, as near self-contact most of the four pairs overlap.
  template <class Push>
  void split(const SubtreePair& part, const Push& push) const {
    const auto [a, b] = part;
    if (a == b) {
      if (!tree_.is_leaf(tree_.left(a))) push(tree_.left(a), tree_.left(a));
      if (!tree_.is_leaf(tree_.right(a))) push(tree_.right(a), tree_.right(a));
      push(tree_.left(a), tree_.right(a));
    } else if (tree_.is_leaf(a)) {
      push(a, tree_.left(b));
      push(a, tree_.right(b));
    } else if (tree_.is_leaf(b)) {
      push(tree_.left(a), b);
      push(tree_.right(a), b);
    } else {
      push(tree_.left(a), tree_.left(b));
      push(tree_.left(a), tree_.right(b));
      push(tree_.right(a), tree_.left(b));
      push(tree_.right(a), tree_.right(b));
    }
  }

  const BinaryTree& tree_;
  const std::vector<Volume>& volumes_;
  std::span<const std::uint8_t> free_within_;
};

}  // namespace tamis::lab

// Which bodies may come near each other during the step, by the boxes that they sweep over.
#pragma once
#include <array>
#include <memory>
#include <vector>

#include "numbers/error_bounds.hpp"
#include "worlds/body.hpp"

namespace tamis {

/// In ascending order.
using BodyPair = std::array<BodyId, 2>;

/// By number; null for bodies that have been removed.
using BodyList = std::vector<std::unique_ptr<Body>>;

/// The distance within which bodies, and items of them, are near each other. It is the separation, plus both radii,
/// plus a multiple of both displacements, plus a margin.
struct NearDistance {
  double separation = 0;
  double displacement_factor = 0;
  bool is_at_start = false;     ///< of bodies as they are at t=0; else at any time of the step
  bool include_static = false;  ///< also of two bodies that stay
  double margin = 0;

  /// What one body adds to the distance.
  double share_of(const Body& body) const;
  double between(const Body& a, const Body& b) const {
    return ((separation + share_of(a) + share_of(b)) * kRoundedUp + margin) * kRoundedUp;
  }
};

/// A tree of the bodies that are switched on and stay, or of those that are switched on and move.
class BodyTree {
 public:
  /// Hulls are widened by each body's share of the distance.
  BodyTree(const BodyList& bodies, bool are_still, const NearDistance& distance);

  /// Calls f(body) for all bodies whose hulls may meet the box.
  template <class F>
  void for_each_near(const Box& box, const F& f) const {
    if (!bodies_.empty()) visit(tree_.root(), box, f);
  }
  std::span<const BodyId> bodies() const { return bodies_; }
  const Box& hull(std::size_t place) const { return hulls_[place]; }

 private:
  template <class F>
  void visit(Index node, const Box& box, const F& f) const {
    if (!may_meet(boxes_[at(node)], box)) return;
    if (tree_.is_leaf(node)) {
      for (const Index i : tree_.items_of(node))
        if (may_meet(hulls_[at(i)], box)) f(bodies_[at(i)]);
    } else {
      tree_.for_each_child(node, [&](Index child) { visit(child, box, f); });
    }
  }

  std::vector<BodyId> bodies_;
  std::vector<Box> hulls_;
  BoxTree tree_;
  std::vector<Box> boxes_;  ///< of its nodes
};

}  // namespace tamis

// Which bodies may come near each other during the step, by what each sweeps over.
#pragma once
#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "world/body.hpp"

namespace tamis {

/// In ascending order.
using BodyPair = std::array<BodyId, 2>;

/// By their numbers; null for those that have been removed.
using BodyList = std::vector<std::unique_ptr<Body>>;

using ReachOfBody = std::function<double(const Body&)>;

/// The bodies that are switched on, those that stay or those that move, in a tree.
class BodyTree {
 public:
  BodyTree() = default;
  /// By what each sweeps over, or holds `at_start`, and reaches farther by itself.
  BodyTree(const BodyList& bodies, bool are_still, const ReachOfBody& own, bool at_start, Split split);

  /// f(body) of all whose hulls may meet the box.
  template <class F>
  void for_each_near(const Box& box, const F& f) const {
    if (!bodies_.empty()) visit(levels_.root_level(), 0, box, f);
  }
  std::span<const BodyId> bodies() const { return bodies_; }
  const Box& hull(std::size_t place) const { return hulls_[place]; }

 private:
  template <class F>
  void visit(int level, Index block, const Box& box, const F& f) const {
    if (level == 0) {
      for (const Index i : order_.items_of(block))
        if (may_meet(hulls_[static_cast<std::size_t>(i)], box)) f(bodies_[static_cast<std::size_t>(i)]);
      return;
    }
    const auto below = levels_.level(level - 1);
    const auto first = static_cast<std::size_t>(block) * kBlock;
    for (std::size_t child = first; child < std::min(first + kBlock, below.size()); ++child)
      if (may_meet(below[child], box)) visit(level - 1, static_cast<Index>(child), box, f);
  }

  std::vector<BodyId> bodies_;
  std::vector<Box> hulls_;
  SpaceOrder order_;
  BoxLevels levels_;
};

/// Keeps the bodies that do not move from question to question.
class NearBodies {
 public:
  /// Throws InvalidOptions if this machine lacks the instruction set.
  explicit NearBodies(Isa isa);
  /// A body that does not move has changed, or has another reach.
  void forget_still() { knows_still_ = false; }

  /// Pairs of bodies, both switched on and not both still, that may come within `separation` and what each reaches
  /// farther by itself, during the step, or `at_start`: ascending.
  std::vector<BodyPair> find(const BodyList& bodies, const ReachOfBody& own, double separation, bool at_start);

 private:
  Split split_;
  bool knows_still_ = false;
  BodyTree still_;
};

}  // namespace tamis

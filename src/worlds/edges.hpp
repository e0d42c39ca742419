// Edges between configurations of a linkage, in a world of their own.
#pragma once
#include <vector>

#include "numbers/pool.hpp"
#include "worlds/edge_prover.hpp"
#include "worlds/linkage_tree.hpp"
#include "worlds/world_state.hpp"

namespace tamis {

/// Answers about edges, for one thread.
class World::State::Edges {
 public:
  /// Copies the bodies. Keeps a reference to the tree. REQUIRES: the world has the tree's bodies.
  Edges(const State& world, const LinkageTree& tree, const PathOptions& asked);

  /// True if the edge is proven free, and its start, unless it is known to, overlaps nothing. Throws InvalidStep.
  bool is_free(std::span<const double> start, std::span<const double> end, bool start_is_free);
  EdgeAnswer last_valid(std::span<const double> start, std::span<const double> end, bool start_is_free);

  Statistics& statistics() { return world_.statistics; }

 private:
  /// Gives the bodies their motions, unless they have them. Throws InvalidStep.
  void move(std::span<const double> start, std::span<const double> end);
  /// Proves pairs apart. Leaves the other pairs in pairs_, ascending. Returns false if the edge surely collides.
  bool prove(std::span<const double> start, std::span<const double> end, bool ends_at_collision);
  /// Two bodies that overlap at the start.
  std::optional<BodyPair> overlapping_pair(std::span<const double> start, std::span<const double> end);
  double separation() const;
  Point point_of(const BodyContact& contact) const;

  const LinkageTree& tree_;
  const PathOptions asked_;
  State world_;
  std::vector<char> is_carried_;  ///< of each body of the world
  bool has_soft_ = false;         ///< a body deforms
  std::optional<EdgeProver> prover_;
  std::vector<BodyPair> pairs_, enclosing_;
  bool is_moved_ = false;
  std::vector<BodyMotion> motions_;
};

/// Testers for the next question about edges, if it is about the same linkage, with the same options, and if nothing
/// has changed.
struct World::State::EdgeTesters {
  /// Keeps a reference to the world.
  EdgeTesters(const State& world, std::shared_ptr<const LinkageTree> of, const PathOptions& now)
      : tree(std::move(of)),
        asked(now),
        turns(world.turns_),
        pool([this, &world](std::size_t) { return std::make_unique<Edges>(world, *tree, asked); }) {}

  const std::shared_ptr<const LinkageTree> tree;
  const PathOptions asked;
  const std::uint64_t turns;
  Pool<Edges> pool;

  bool serve(const std::shared_ptr<const LinkageTree>& of, const PathOptions& now, std::uint64_t turns_now) const {
    return tree == of && asked.min_separation == now.min_separation && asked.tolerance == now.tolerance &&
           turns == turns_now;
  }
};

}  // namespace tamis

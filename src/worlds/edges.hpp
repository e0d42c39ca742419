// Edges between configurations of a linkage, in a world of their own.
#pragma once
#include <vector>

#include "worlds/edge_prover.hpp"
#include "worlds/linkage_tree.hpp"
#include "worlds/world_state.hpp"

namespace tamis {

/// Answers about edges, for one thread.
class World::State::Edges {
 public:
  /// Copies the bodies. Keeps references to the tree and the options. REQUIRES: the world has the tree's bodies.
  Edges(const State& world, const LinkageTree& tree, const PathOptions& asked);

  /// True if the edge is proven free, and its start, unless it is known to, overlaps nothing. Throws InvalidStep.
  bool is_free(std::span<const double> start, std::span<const double> end, bool start_is_free);
  EdgeAnswer last_valid(std::span<const double> start, std::span<const double> end, bool start_is_free);

  const Statistics& statistics() const { return world_.statistics; }

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
  const PathOptions& asked_;
  State world_;
  std::vector<char> is_carried_;  ///< of each body of the world
  bool has_soft_ = false;         ///< a body deforms
  std::optional<EdgeProver> prover_;
  std::vector<BodyPair> pairs_, enclosing_;
  bool is_moved_ = false;
  std::vector<BodyMotion> motions_;
};

}  // namespace tamis

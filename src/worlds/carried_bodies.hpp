// Bodies that turn together: pairs of bodies whose chains share outer links. Each pair is queried in the frame of the
// last shared link. In this frame only the links behind it move (docs/numerics/curves.md, "Bodies that turn together").
#pragma once
#include <vector>

#include "worlds/near_bodies.hpp"

namespace tamis {

/// True if both bodies turn, and their outermost links are equal.
bool turn_together(const Body& a, const Body& b);

/// Pairs that share the same links, and no more.
struct CarriedPairs {
  RigidChain carrier;  ///< the shared links
  std::vector<BodyPair> pairs;

  /// The bodies of the pairs, and other bodies that share the links, as the frame sees them. Null for all others.
  BodyList in_frame(const BodyList& bodies, const std::vector<BodyId>& others) const;
};

/// The pairs that turn together, ascending in each frame.
std::vector<CarriedPairs> carried_pairs(const BodyList& bodies, const std::vector<BodyPair>& pairs);

/// For each of these bodies the first one of them that turns together with it, which may be itself. REQUIRES: no null
/// pointer among them.
std::vector<BodyId> first_of_carrier(const BodyList& bodies, const std::vector<BodyId>& ids);

}  // namespace tamis

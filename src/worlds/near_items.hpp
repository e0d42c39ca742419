// Finds the items of bodies that may come near items of others. Traverses two hierarchies at once, in the frame of the
// world.
#pragma once
#include <map>
#include <span>
#include <vector>

#include "numbers/held_bytes.hpp"
#include "worlds/index_set.hpp"
#include "worlds/near_bodies.hpp"

namespace tamis {

/// Items of bodies that may come near others, and the pairs of these bodies.
struct NearItems {
  std::map<BodyId, IndexSet> of_body;
  std::vector<BodyPair> pairs;  ///< of those bodies; ascending

  bool includes(const NearItems& other) const;
  std::size_t count() const;
  std::uint64_t memory_bytes() const { return held_bytes(pairs, of_body); }
};

/// Adds to `near` all items of the pairs that may come within the distance on the pieces between successive `times`.
/// Items that `near` holds already are not tested again once their bodies are known to come near. Throws Cancelled.
/// REQUIRES: `pairs` and `times` ascending, two times at least.
void add_near_items(const BodyList& bodies, const std::vector<BodyPair>& pairs, const NearDistance& distance,
                    std::span<const double> times, const Options& options, NearItems& near);

}  // namespace tamis

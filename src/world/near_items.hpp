// Which items of bodies may come near items of others: two hierarchies walked together, in the frame of the world.
#pragma once
#include <functional>
#include <map>
#include <vector>

#include "numerics/held_bytes.hpp"
#include "world/index_set.hpp"
#include "world/near_bodies.hpp"
#include "world/pieces.hpp"

namespace tamis {

/// Of some bodies.
struct NearItems {
  std::map<BodyId, IndexSet> of_body;
  std::vector<BodyPair> pairs;  ///< of those bodies; ascending

  bool includes(const NearItems& other) const;
  std::size_t count() const;
  std::uint64_t memory_bytes() const { return held_bytes(pairs, of_body); }
};

/// Adds to `near` all that may come as near as `reach` says, during the pieces. Items in it are not looked at again
/// where their bodies are known to come near. `pause` is called now and then, and may throw. REQUIRES: `pairs`
/// ascending.
void add_near_items(const BodyList& bodies, const std::vector<BodyPair>& pairs,
                    const std::function<double(const Body&, const Body&)>& reach, Pieces& pieces, const Pause& pause,
                    NearItems& near);

}  // namespace tamis

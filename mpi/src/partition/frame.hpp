// Lends the elements that reach farthest on each side of the scene to all ranks. The boxes of every search, and so the
// last bits of its answers, are in a frame that spans the whole scene (docs/numerics.md, "Boxes").
#pragma once
#include <set>

#include "mpi/src/communicator.hpp"
#include "mpi/src/partition/element_set.hpp"

namespace tamis::distributed {

class Frame {
 public:
  explicit Frame(Communicator& communicator) : communicator_(communicator) {}

  /// To be called when elements get new places.
  void forget() { lent_.clear(); }
  /// Collective. Returns the elements of all ranks that reach farthest now, and some that did before, so that the set
  /// seldom changes.
  ElementSet span(const ElementSet& own);

 private:
  void choose(const ElementSet& own);

  Communicator& communicator_;
  std::set<std::uint32_t> lent_;  ///< places in `own`
};

}  // namespace tamis::distributed

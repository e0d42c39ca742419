// The elements that reach farthest on each side of the scene, lent to all: the boxes of every search, and so the last
// bits of what it finds, are in a frame that spans the whole scene (docs/numerics.md, "Boxes").
#pragma once
#include <set>

#include "mpi/src/communicator.hpp"
#include "mpi/src/partition/element_set.hpp"

namespace tamis::distributed {

class Frame {
 public:
  explicit Frame(Communicator& communicator) : communicator_(communicator) {}

  /// Elements have new places.
  void forget() { lent_.clear(); }
  /// Collective. Those that reach farthest now, of all ranks, and some that did before: a set that changes seldom.
  ElementSet span(const ElementSet& own);

 private:
  void choose(const ElementSet& own);

  Communicator& communicator_;
  std::set<std::uint32_t> lent_;  ///< places in `own`
};

}  // namespace tamis::distributed

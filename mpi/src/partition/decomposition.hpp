// Who searches among which elements: a decomposition by space, for contact alone, that has nothing to do with what rank
// the caller keeps an element on. It is kept from step to step while work is balanced; only positions are sent then.
#pragma once
#include <vector>

#include "mpi/src/communicator.hpp"
#include "mpi/src/partition/element_set.hpp"

namespace tamis::distributed {

class Decomposition {
 public:
  explicit Decomposition(Communicator& communicator) : communicator_(communicator) {}

  /// Collective. Cuts space anew by where elements are in the middle of what they sweep over, each with the weight that
  /// was reported for it last, and sends every element to its owner. `input`: with motions, the same ones at every
  /// call.
  void decompose(const ElementSet& input);
  /// Collective. Sends owners the motions of their vertices.
  void send_motions(const ElementSet& input);
  /// Collective. What each owned element weighed, for the next cuts.
  void report_weights(const std::vector<std::uint64_t>& weights);

  /// With ids and motions; near elements are near each other in it.
  const ElementSet& own() const { return own_; }

 private:
  /// What this rank sent to an owner, or an owner received from it.
  struct Share {
    int rank;
    std::vector<std::uint32_t> elements;  ///< places
    std::vector<std::uint32_t> vertices;  ///< places
  };

  void send_elements(const ElementSet& input, const std::vector<int>& owners);
  void put_in_spatial_order();

  Communicator& communicator_;
  bool is_ordered_ = false;
  std::vector<std::uint64_t> weights_;  ///< of the input's elements
  std::vector<Share> sent_, received_;
  ElementSet own_;
};

}  // namespace tamis::distributed

// Which rank searches among which elements: a decomposition by space, for contact alone, independent of the rank that
// gives an element. It is kept from step to step while work is balanced; then only positions are sent.
#pragma once
#include <vector>

#include "distributed/src/communicator.hpp"
#include "distributed/src/partition/element_set.hpp"

namespace tamis::distributed {

class Decomposition {
 public:
  explicit Decomposition(Communicator& communicator) : communicator_(communicator) {}

  /// Collective. Cuts space anew, by the middle of the region that each element sweeps over and by the weight last
  /// reported for it, and sends every element to its owner. `input`: with motions; the same elements at every call.
  void decompose(const ElementSet& input);
  /// Collective. Sends owners the motions of their vertices.
  void send_motions(const ElementSet& input);
  /// Collective. Reports a weight for each owned element, for the next cuts.
  void report_weights(const std::vector<std::uint64_t>& weights);

  /// The elements that this rank owns, with ids and motions, in a spatial order.
  const ElementSet& own() const { return own_; }

 private:
  /// The elements that this rank sent to one owner, or as owner received from one rank.
  struct Share {
    int rank;
    std::vector<std::uint32_t> elements;  ///< places
    std::vector<std::uint32_t> vertices;  ///< places
  };

  void send_elements(const ElementSet& input, const std::vector<int>& owners);
  void put_in_spatial_order();

  Communicator& communicator_;
  bool is_ordered_ = false;
  std::vector<std::uint64_t> weights_;  ///< one for each element of the input
  std::vector<Share> sent_, received_;
  ElementSet own_;
};

}  // namespace tamis::distributed

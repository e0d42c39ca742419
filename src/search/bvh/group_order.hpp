// An order by groups: features of a group without self-contact, such as a rigid body, come one after the other in the
// tree. So blocks of one such group are never tested against each other.
#pragma once
#include <span>
#include <vector>

#include "search/bvh/spatial_order.hpp"

namespace tamis {

/// A feature's sort key: its group, and one of its points (three coordinates).
struct GroupedFeature {
  Index group;
  const float* at;
};

/// Features, one group after the other.
struct GroupOrder {
  std::vector<Index> features;
  std::vector<std::size_t> ends;  ///< of the groups, ascending: places in `features`
};

/// Orders the groups with `no_self_contact` by their centers in space. So neighbours share the block in which one ends
/// and the next begins. All other features are one group. Empty where many groups overlap: an order in space alone
/// serves better there. REQUIRES: `no_self_contact` of all groups.
GroupOrder order_groups(std::span<const GroupedFeature> features, std::span<const std::uint8_t> no_self_contact);

}  // namespace tamis

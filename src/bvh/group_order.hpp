// Groups of features that never touch themselves, such as rigid bodies, are kept together in the order of a tree: a
// block of one such group is not looked at beside others of it.
#pragma once
#include <span>
#include <vector>

#include "bvh/spatial_order.hpp"

namespace tamis {

/// What of a feature decides where it comes: its group, and a point of it in space (three coordinates).
struct GroupedFeature {
  Index group;
  const float* at;
};

/// Features, one group after the other.
struct GroupOrder {
  std::vector<Index> features;
  std::vector<std::size_t> ends;  ///< of the groups, ascending: places in `features`
};

/// Groups with `is_apart` come as their middles lie in space, so that neighbours share the block in which one ends and
/// the next begins; all others are one group. Empty where many groups lie in each other, and an order in space alone
/// serves better. REQUIRES: `is_apart` of all groups.
GroupOrder order_groups(std::span<const GroupedFeature> features, std::span<const std::uint8_t> is_apart, Split split);

}  // namespace tamis

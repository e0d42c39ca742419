// Groups of features that never touch themselves, such as rigid bodies, are kept together in the order of a tree: a
// block of one such group is not looked at beside others of it.
#pragma once
#include <array>
#include <functional>
#include <span>
#include <vector>

#include "bvh/spatial_order.hpp"

namespace tamis {

/// Features, one group after the other.
struct GroupOrder {
  std::vector<Index> features;
  std::vector<std::size_t> ends;  ///< of the groups, ascending: places in `features`
};

/// Of features of which each has a group and a place in space. Groups with `is_apart` come as their middles lie in
/// space, so that neighbours share what the end of one and the beginning of the next leave of a block; all others are
/// one group. REQUIRES: `is_apart` of all groups.
GroupOrder order_groups(std::span<const Index> group_of, const std::function<const float*(std::size_t)>& place_of,
                        std::span<const std::uint8_t> is_apart, Split split);

}  // namespace tamis

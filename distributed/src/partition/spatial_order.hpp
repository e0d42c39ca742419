// An order in which near elements stand side by side, in the groups that a BoxTree makes of them.
#pragma once
#include <cstdint>
#include <vector>

#include "distributed/src/partition/element_set.hpp"

namespace tamis::distributed {

/// For each element the middle of the region that it sweeps over.
std::vector<Point> centers_of(const ElementSet& set);

/// The places of the points in spatial order, by halving space again and again.
std::vector<std::uint32_t> spatial_order(const std::vector<Point>& points);

}  // namespace tamis::distributed

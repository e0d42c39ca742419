// Elements in an order in which near ones stand side by side, in the groups that a BoxTree makes of them.
#pragma once
#include <cstdint>
#include <vector>

#include "mpi/src/partition/element_set.hpp"

namespace tamis::distributed {

/// Of each element the middle of what it sweeps over.
std::vector<Point> centers_of(const ElementSet& set);

/// Places of points, space being halved again and again.
std::vector<std::uint32_t> spatial_order(const std::vector<Point>& points);

}  // namespace tamis::distributed

// Do surfaces pass through each other, or touch, in one pose?
#pragma once
#include <vector>

#include "tamis/contact.hpp"
#include "tamis/detector.hpp"

namespace tamis::simulation {

/// Continuous detection finds what comes together, not what has been together all along. But a point that runs along
/// an edge within the step meets every triangle that the edge passes through: each edge becomes one such point.
/// Decided exactly. `pairs`: groups of vertices that may pass through each other; no function.
std::vector<Contact> find_intersections(const Mesh& mesh, Positions positions, const PairFilter& pairs = {});

}  // namespace tamis::simulation

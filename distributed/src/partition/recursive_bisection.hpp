// Cuts space in two again and again, so that each part has its share of the weight (Berger, Bokhari 1987). All ranks
// find the cuts together; no rank sees the others' points.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "distributed/src/communicator.hpp"
#include "tamis/step.hpp"

namespace tamis::distributed {

/// Collective. Returns for each of this rank's points its part, in [0, size of the communicator). Equal points are in
/// one part, whatever rank has them. The sum of all weights must stay below 2^64.
std::vector<int> bisect(Communicator& communicator, std::span<const Point> points,
                        std::span<const std::uint64_t> weights);

}  // namespace tamis::distributed

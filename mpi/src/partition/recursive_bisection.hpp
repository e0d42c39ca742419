// Space cut in two again and again, so that each part has as much of the weight as its share of the ranks: Berger and
// Bokhari 1987. All ranks find the cuts together; nobody sees the others' points.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "mpi/src/communicator.hpp"
#include "tamis/step.hpp"

namespace tamis::distributed {

/// Collective. The part, in [0, size of the communicator), of each of this rank's points. Equal points are in one part,
/// on whatever ranks they are. Sums of weights must stay below 2^64.
std::vector<int> bisect(Communicator& communicator, std::span<const Point> points,
                        std::span<const std::uint64_t> weights);

}  // namespace tamis::distributed

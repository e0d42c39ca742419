// Did a body that flew pass through what stands? Asked in two ways that share nothing with World or with each other.
#pragma once
#include "adapters/bullet/throws/arena.hpp"

namespace tamis::bullet {

/// Steps in which two bodies touch: a Detector asked about the path of all, as one mesh. 0 is a proof that none did.
int touching_steps(std::span<const Triangles> bodies, const Places& places);
int touching_steps(const Arena& arena, const Flight& flight);

/// Of the fixed surface, which stays, and the flying one.
Places places_of(const Flight& flight);

/// Steps in which at one of `samples` times an edge of one passes through a triangle of the other: positions and
/// signs of volumes in doubles. Misses what happens between the times.
int sampled_crossings(const Arena& arena, const Flight& flight, int samples);

}  // namespace tamis::bullet

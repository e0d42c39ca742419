// Did a flying body pass through the fixed mesh? Tested in two ways that share nothing with World or with each other.
#pragma once
#include "integrations/bullet/throws/arena.hpp"

namespace tamis::bullet {

/// The number of steps in which two bodies touch, by a Detector that is asked about the path of all bodies as one mesh.
/// 0 is a proof that none did.
int touching_steps(std::span<const Triangles> bodies, const Places& places);
int touching_steps(const Arena& arena, const Flight& flight);

/// The places of the fixed mesh, which stays, and of the flying body.
Places places_of(const Flight& flight);

/// The number of steps in which, at one of `samples` times, an edge of one mesh passes through a triangle of the other:
/// by signs of volumes in doubles. Misses crossings between the times.
int sampled_crossings(const Arena& arena, const Flight& flight, int samples);

}  // namespace tamis::bullet

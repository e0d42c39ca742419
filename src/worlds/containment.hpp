// Whether a body encloses a part of another one at t=0. Such bodies touch nowhere, so no other question tells.
#pragma once
#include "worlds/body.hpp"

namespace tamis {

/// True if the whole surface of the body is closed. Where a deforming body's seams have come apart at t=0 it is not.
bool is_closed(const Body& body);

/// True if a vertex of `inner` lies in a closed part of `outer`, or on it, at t=0. Tests one vertex of each connected
/// part of `inner`: where no edge passes through a face, the others lie as it does. Decided exactly for positions
/// rounded to doubles. Throws Cancelled, as `options` say.
bool encloses(const Body& outer, const Body& inner, const Options& options);

}  // namespace tamis

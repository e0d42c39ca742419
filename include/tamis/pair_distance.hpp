// How far apart one pair of features is, and how long it may go so as to keep a part of that.
#pragma once
#include "tamis/near.hpp"
#include "tamis/pair.hpp"

namespace tamis {

/// The distance of a pair at rest, with its proven error, weights and direction: what Detector::near says of it. The
/// start of a step is such a rest. Throws InvalidStep as narrow_phase does.
NearPair distance_of(const Pair& pair, const Positions& positions);

/// How far may one pair go so that its distance, as far as it exceeds the minimum separation, stays at least `fraction`
/// of what it is at t=0? As Detector::keep_distance, for one pair; it looks no further than options.latest, which
/// `lower` then is. Throws InvalidOptions unless 0 <= fraction < 1, InvalidStep as narrow_phase does.
SafeStep keep_distance(const Pair& pair, const Step& step, double fraction = 0.1, const PairOptions& options = {});

}  // namespace tamis

// How far apart one pair of features is, and how long it may go so as to keep a part of that.
#pragma once
#include "tamis/pair.hpp"
#include "tamis/proximity.hpp"

namespace tamis {

/// The distance of a pair at rest, with its proven error, weights and direction: what Detector::pairs_within says of
/// it. The start of a step is such a rest. Throws InvalidStep as narrow_phase does.
NearPair distance_of(const Pair& pair, const Positions& positions);

/// How far may one pair go so that its distance, as far as it exceeds the minimum separation, stays at least `keep`
/// of what it is at t=0? As Detector::safe_step, for one pair; it looks no further than options.latest, which
/// `lower` then is. Throws InvalidOptions unless 0 <= keep < 1, InvalidStep as narrow_phase does.
SafeStep safe_step(const Pair& pair, const Step& step, double keep = 0.1, const PairOptions& options = {});

}  // namespace tamis

// The distance of one pair of features, and until when the pair keeps a part of it.
#pragma once
#include "tamis/pair.hpp"
#include "tamis/positions.hpp"
#include "tamis/proximity.hpp"
#include "tamis/step.hpp"
#include "tamis/step_length.hpp"

namespace tamis {

/// The distance of a pair in one pose, such as the start of a step, with weights and direction: what
/// Detector::pairs_within says of it. Throws InvalidStep as narrow_phase does.
NearPair distance_of(const Pair& pair, const Positions& positions);

/// How far may one pair go so that its distance, as far as it exceeds the minimum separation, stays at least `keep`
/// of what it is at t=0? As Detector::safe_step, for one pair; it looks no further than options.latest, which
/// `lower` then is. Throws InvalidOptions unless 0 <= keep < 1, InvalidStep as narrow_phase does.
SafeStep safe_step(const Pair& pair, const Step& step, double keep = 0.1, const PairOptions& options = {});

}  // namespace tamis

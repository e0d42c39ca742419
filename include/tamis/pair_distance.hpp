// The distance of one pair of features, and the time until which the pair keeps a fraction of it.
#pragma once
#include "tamis/pair.hpp"
#include "tamis/positions.hpp"
#include "tamis/proximity.hpp"
#include "tamis/step.hpp"
#include "tamis/step_length.hpp"

namespace tamis {

/// Computes the distance of a pair in one pose, such as the start of a step.
/// Returns it with weights and direction, as Detector::pairs_within does.
/// Throws InvalidStep as narrow_phase does.
[[nodiscard]] NearPair distance_of(const FeaturePair& pair, const Positions& positions);

/// Finds how far one pair may go while it keeps at least the fraction `keep` of its distance at t=0. This is
/// Detector::safe_step for one pair. The distance that counts is what exceeds the minimum separation. Searches up to
/// options.latest.
/// Returns a bracket of the time. A pair that keeps its fraction until options.latest has this as `toi_lower`.
/// Throws InvalidOptions unless 0 <= keep < 1, InvalidStep as narrow_phase does.
[[nodiscard]] SafeStep safe_step(const FeaturePair& pair, const Step& step, double keep = 0.1,
                                 const PairOptions& options = {});

}  // namespace tamis

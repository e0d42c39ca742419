// The distance of one pair of features, and the time until which the pair keeps a fraction of it.
#pragma once
#include "tamis/pair.hpp"
#include "tamis/positions.hpp"
#include "tamis/proximity.hpp"
#include "tamis/step.hpp"
#include "tamis/step_length.hpp"

namespace tamis {

/// The distance of a pair in one pose, such as the start of a step, with weights and direction, as
/// Detector::pairs_within returns them. Throws InvalidStep as narrow_phase does.
NearPair distance_of(const FeaturePair& pair, const Positions& positions);

/// How far may one pair go so that it keeps at least the fraction `keep` of its distance at t=0? The distance that
/// counts is what exceeds the minimum separation. As Detector::safe_step, for one pair. It searches up to
/// options.latest; a pair that keeps its fraction until then has `toi_lower` = options.latest. Throws InvalidOptions
/// unless 0 <= keep < 1, InvalidStep as narrow_phase does.
SafeStep safe_step(const FeaturePair& pair, const Step& step, double keep = 0.1, const PairOptions& options = {});

}  // namespace tamis

// The last word: exact algebra on the double inputs.
#pragma once
#include "motion/make_motion.hpp"
#include "tamis/contact.hpp"

namespace tamis {

struct ExactDecision {
  bool touches = false;
  /// The first time of touching lies in [toi_lower, toi_upper]: equal, or neighbouring doubles, within [0,1].
  double toi_lower = 1;
  double toi_upper = 1;
};

/// Is there a t in [0,1] at which the two closed features share a point? All degeneracies are decided.
/// REQUIRES: finite coordinates.
ExactDecision decide_exactly(PairKind kind, const PairPoints& points);

}  // namespace tamis

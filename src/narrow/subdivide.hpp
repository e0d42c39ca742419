// The pairs one crossing cannot decide: the step is cut in time, earliest part first, until each part is proven free,
// holds one certified crossing, or is too short to be decided in this arithmetic.
#pragma once
#include "filters/slab_clip.hpp"
#include "motion/pair_motion.hpp"
#include "tamis/contact.hpp"

namespace tamis {

enum class Verdict : std::uint8_t { is_free, touches, unsure };

/// Times of the step. The pair is apart on [0, lower); `touches`: it touches within [lower, upper].
struct Decision {
  Verdict verdict = Verdict::is_free;
  double lower = 1, upper = 1;
};

/// REQUIRES: `m` is the motion of the whole step, finite; `time` is a part of it; the kind can cross. REQUIRES (not
/// checked: exact): the pair is apart outside `time`.
Decision subdivide(PairKind kind, const PairMotion<double>& m, const TimeInterval<double>& time);

}  // namespace tamis

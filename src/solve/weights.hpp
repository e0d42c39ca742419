// Where two features touch: contact weights and normal at one time.
#pragma once
#include "motion/pair_motion.hpp"
#include "tamis/pair.hpp"

namespace tamis {

/// Sets u, v and normal, rounded: those of the closest points at `time` of the motion.
void add_weights(PairKind kind, const PairMotion<double>& m, double time, PairResult& result);

}  // namespace tamis

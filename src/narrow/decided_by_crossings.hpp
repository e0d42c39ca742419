// What one certified crossing decides of one pair, or two in halves of its time: most pairs, and what lanes decide.
#pragma once
#include <optional>

#include "motion/make_motion.hpp"
#include "motion/time_clip.hpp"
#include "tamis/pair.hpp"

namespace tamis {

/// Nothing where that takes more, or it is no crossing that decides the pair. A pair that is free until `latest` may
/// be said to be free.
std::optional<PairResult> decided_by_crossings(const PairInStep& pair, double latest);

/// Does the clip prove the pair free until `latest`?
inline bool is_proven_free(const TimeInterval<double>& clip, double latest) {
  return clip.t_in > clip.t_out || clip.t_in > latest;
}

}  // namespace tamis

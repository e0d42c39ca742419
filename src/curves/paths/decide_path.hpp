// The decision on one pair that moves on curves. The time is cut, earliest part first, until each part is proven free,
// holds a certified crossing in a narrow bracket, or is too short for the arithmetic. The arithmetic is doubles, then
// double-double.
#pragma once
#include <optional>

#include "curves/paths/path_reader.hpp"
#include "pair/motion/decision.hpp"
#include "pair/motion/time_clip.hpp"
#include "pair/narrow/kept_distance.hpp"

namespace tamis {

struct PathQuestion {
  const Path& path;
  PairKind kind;
  PairVertices vertices;
  double min_separation, tolerance;  ///< as in PairOptions
  const std::function<bool()>& is_cancelled;
};

/// Decides the pair during `time`; the Decision means the same as for straight motion. `touches`: the bracket is no
/// wider than the tolerance. Throws Cancelled. REQUIRES: `kind` is a PairKind, `time` a part of [0,1].
Decision decide_on_path(const PathQuestion& question, const TimeInterval<double>& time);

/// The recontact of a pair that may touch at the start of `time`. Decides it from the first probed time when it is
/// proven apart. Probes 2^-20, 2^-19, ... 2^-4 of `time` after its start, then each sixteenth. Returns nothing if the
/// pair is proven apart at no probe.
std::optional<Decision> decide_recontact_on_path(const PathQuestion& question, const TimeInterval<double>& time);

/// Proven bounds of the distance that a pair must keep, D + F (distance at t=0 - D).
struct KeptSeparation {
  double low, high;
  bool is_near_separation;  ///< not proven farther apart than D at t=0
};
KeptSeparation kept_separation(const Path& path, PairKind kind, const PairVertices& vertices, const DistanceRule& rule);

/// The result with weights and normal at the contact.
PairResult result_on_path(const PathQuestion& question, const Decision& decision);

}  // namespace tamis

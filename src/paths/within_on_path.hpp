// Minimum separation on a path: the chords of a piece are asked when they come within the separation and their
// deviations (narrow/separation.hpp); until then the curves are apart, and there the next, shorter piece begins.
#pragma once
#include "motion/make_motion.hpp"
#include "narrow/kept_distance.hpp"
#include "paths/decide_path.hpp"

namespace tamis {

/// The middles of two moments; finite, also where an error is not.
PairPoints points_between(const Moment<double>& from, const Moment<double>& to);

/// By how much the distance of two points, one of each feature, can differ from that of their middles: sqrt(3) half
/// widths each, given twice that for what middles round. `error`: of their moment.
inline double position_slack(double error) { return 4 * error + 0x1p-999; }

/// At one time: is the distance beyond the separation, certainly?
bool is_apart_at(PairKind kind, const Moment<double>& moment, double separation);

/// D + F (distance at t=0 - D), between proven bounds.
struct KeptSeparation {
  double low, high;
  double distance;        ///< at t=0, rounded
  bool may_start_within;  ///< D: not proven apart at t=0
};

/// Step lengths on curves: what a pair must keep of its distance at t=0 is a separation, and when it is reached is
/// asked as of any other.
KeptSeparation kept_separation(const Path& path, PairKind kind, const PairVertices& vertices, const DistanceRule& rule);

/// As decide_on_path. REQUIRES: a separation > 0, a part of the path. REQUIRES (not checked: history): `reader` reads
/// the question's pair.
Decision first_within_on_path(const PathQuestion& question, const PairReader& reader, const TimeInterval<double>& time);

}  // namespace tamis

// Minimum separation on a path: the time at which the chords of a piece come within the separation plus their
// deviations (narrow/first_within.hpp). Until then the curves are apart; the next, shorter piece begins there.
#pragma once
#include "motion/make_motion.hpp"
#include "paths/decide_path.hpp"

namespace tamis {

/// The middles of the intervals at two moments; finite even where an error is not.
PairPoints points_between(const Moment<double>& from, const Moment<double>& to);

/// A bound of the difference between the distance of two points, one of each feature, and that of their intervals'
/// middles: sqrt(3) half widths for each point, doubled because middles are rounded. `error`: Moment::error.
inline double position_slack(double error) { return 4 * error + 0x1p-999; }

/// At one time: is the distance beyond the separation, certainly?
bool is_apart_at(PairKind kind, const Moment<double>& moment, double separation);

/// As decide_on_path. REQUIRES: a separation > 0, `time` is a part of [0,1]. REQUIRES (not checked: history): `reader`
/// reads the question's pair.
Decision first_within_on_path(const PathQuestion& question, const PairReader& reader, const TimeInterval<double>& time);

}  // namespace tamis

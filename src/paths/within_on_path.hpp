// Minimum separation on a path: the time at which the chords of a piece come within the separation plus their
// deviations (narrow/first_within.hpp). Until then the curves are apart; the next, shorter piece begins there.
#pragma once
#include "motion/make_motion.hpp"
#include "paths/decide_path.hpp"

namespace tamis {

/// The middles of two moments; finite, also where an error is not.
PairPoints points_between(const Moment<double>& from, const Moment<double>& to);

/// By how much the distance of two points, one of each feature, can differ from that of their intervals' middles: by
/// sqrt(3) half widths each; given twice that, as middles are rounded. `error`: of their moment.
inline double position_slack(double error) { return 4 * error + 0x1p-999; }

/// At one time: is the distance beyond the separation, certainly?
bool is_apart_at(PairKind kind, const Moment<double>& moment, double separation);

/// As decide_on_path. REQUIRES: a separation > 0, a part of the path. REQUIRES (not checked: history): `reader` reads
/// the question's pair.
Decision first_within_on_path(const PathQuestion& question, const PairReader& reader, const TimeInterval<double>& time);

}  // namespace tamis

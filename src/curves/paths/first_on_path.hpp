// The first contact of a pair on its path.
#pragma once
#include "curves/paths/decide_path.hpp"

namespace tamis {

// REQUIRES, both: `time` is a part of [0,1]. REQUIRES (not checked: history): `reader` reads the question's pair.

/// decide_on_path for a pair without a separation. Cuts the path in time until each part is proven free or holds a
/// crossing. At a crossing the coplanarity d.(e x f) has different signs at the part's ends.
Decision first_crossing_on_path(const PathQuestion& question, const PairReader& reader,
                                const TimeInterval<double>& time);

/// decide_on_path for a pair with a separation > 0: the time at which the chords of a piece come within the separation
/// plus their deviations (pair/narrow/first_within.hpp). Until then the curves are apart; the next, shorter piece
/// begins there.
Decision first_within_on_path(const PathQuestion& question, const PairReader& reader, const TimeInterval<double>& time);

/// True if at one time the distance is certainly beyond the separation.
bool is_apart_at(PairKind kind, const Moment<double>& moment, double separation);

}  // namespace tamis

// Exact decisions on one pair: integer algebra on the inputs, which are doubles.
#pragma once
#include "pair/motion/decision.hpp"
#include "pair/motion/make_motion.hpp"
#include "tamis/contact.hpp"

namespace tamis {

/// Finds the first t in [0,1] at which the distance of the two closed features is at most `separation`. With a
/// separation of zero they share a point then. All degeneracies are decided. The answer is never unsure. The ends of
/// its bracket are equal, or neighbouring doubles. A pair that is free until `latest` may be said to be free. REQUIRES:
/// finite coordinates, a finite separation >= 0, `latest` in [0,1].
Decision decide_exactly(PairKind kind, const PairPoints& points, double separation = 0, double latest = 1);

/// Recontact. The same, but a pair that touches at t=0 counts only from the time when it touches again after it has
/// separated.
Decision decide_recontact_exactly(PairKind kind, const PairPoints& points, double separation = 0);

/// The side of the second feature on which the first one is: the sign of its place along e x f
/// (pair/motion/pair_motion.hpp) at `time`, or just before it if the four points are coplanar at `time`. At t=0 the
/// motion is continued backwards. 0: they are coplanar throughout. REQUIRES: finite coordinates, `time` in [0,1], a
/// kind that can cross.
int side_just_before(PairKind kind, const PairPoints& points, double time);

}  // namespace tamis

// The decision on one pair, cheap arithmetic first: slab clip, one or two certified crossings; beginnings of the step
// of a pair that goes far; subdivision in time, or with a separation advancement; double-double; integers. All engines
// hand the pairs they leave undecided to these functions, so that they return the same set of contacts.
#pragma once
#include "motion/make_motion.hpp"
#include "narrow/contact_rule.hpp"
#include "tamis/pair.hpp"
#include "tamis/statistics.hpp"

namespace tamis {

/// REQUIRES: a kind there is, finite coordinates, a valid rule. Counts in `decided_by` which
/// arithmetic had the last word.
PairResult decide(PairKind kind, const PairPoints& points, const ContactRule& rule, PrecisionCount& decided_by);

/// The same. REQUIRES: decided_by_crossing.hpp does not decide the pair, which has been tried where many are tried at
/// once.
PairResult decide_undecided(PairKind kind, const PairPoints& points, const ContactRule& rule,
                            PrecisionCount& decided_by);

/// Recontact: does a pair that touches at t=0 touch again, after it has come apart? REQUIRES (not checked: exact): it
/// touches at t=0.
PairResult decide_recontact(PairKind kind, const PairPoints& points, double separation, PrecisionCount& decided_by);

}  // namespace tamis

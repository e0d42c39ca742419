// Answers "is there a t in [0,1] at which these polynomials have these signs?" without ever computing a root:
// Sturm-Tarski sequences count the roots of one polynomial at which others are positive (Basu, Pollack, Roy, Algorithms
// in Real Algebraic Geometry, 2nd ed. 2006, section 2.2.2).
#pragma once
#include <span>
#include <vector>

#include "oracle/polynomial.hpp"

namespace tamis::oracle {

enum class Relation { positive, not_negative };

/// p(t) > 0, or p(t) >= 0.
struct Condition {
  Polynomial p;
  Relation relation;
};

/// All of [0,1], or [0,1) without its last point.
enum class Range { closed, half_open };

/// Number of roots of p in (0,1), each counted once. REQUIRES: p is not zero, and has no root at 0 or 1.
int count_roots(const Polynomial& p);

/// Is there a root of p in (0,1) at which all conditions hold? By counting alone, which is slow and always ends.
/// REQUIRES: p is not zero, and has no root at 0 or 1.
bool holds_at_counted_root(const Polynomial& p, std::span<const Condition> conditions);

/// Is there a t in the range with zero(t) = 0 at which all conditions hold? Decides plain cases without counting.
bool holds_somewhere(const Polynomial& zero, const std::vector<Condition>& conditions, Range range);

}  // namespace tamis::oracle

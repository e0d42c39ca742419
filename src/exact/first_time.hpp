// The first of several times, each a root of one of the polynomials of an exact decision.
#pragma once
#include "exact/exact.hpp"
#include "exact/root_isolation.hpp"
#include "numerics/assert.hpp"

namespace tamis {

/// Brackets need not be compared exactly: the largest double below a time and the smallest above it grow with it.
class FirstTime {
 public:
  /// The first root of `p` in [0,1] for which `holds(time)`, if there is one. REQUIRES: `p` is not zero.
  template <class Condition>
  void add_roots(const IntegerPolynomial& p, const Condition& holds) {
    TAMIS_ASSERT(!p.is_zero());
    for (AlgebraicTime& time : roots_in_unit_interval(p))
      if (holds(time)) return add(time.bracket());
  }
  void add(const AlgebraicTime::Bracket& time) {
    if (first_.touches && time.lower >= first_.toi_lower && time.upper >= first_.toi_upper) return;
    first_ = {true, time.lower, time.upper};
  }

  const ExactDecision& decision() const { return first_; }

 private:
  ExactDecision first_;
};

}  // namespace tamis

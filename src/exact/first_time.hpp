// The times at which a pair touches that are roots of the polynomials of an exact decision: the first of them, or the
// first after the pair has come apart.
#pragma once
#include <vector>

#include "exact/root_isolation.hpp"
#include "motion/decision.hpp"
#include "numerics/assert.hpp"

namespace tamis {

/// Times are compared by their brackets, which ascend with them. Of pairs apart at t=0 alone: one that moves within its
/// plane may go on touching without any of these times.
class FirstTime {
 public:
  /// The first root of `p` in [0,1] for which `holds(time)`, if there is one. REQUIRES: `p` is not zero.
  template <class Condition>
  void add_roots(const IntegerPolynomial& p, const Condition& holds) {
    TAMIS_ASSERT(!p.is_zero());
    for (AlgebraicTime& time : roots_in_unit_interval(p, first_.touches() ? first_.upper : 1))
      if (holds(time)) return add(time.bracket());
  }

  const Decision& decision() const { return first_; }

 private:
  void add(const TimeInterval<double>& time) {
    if (first_.touches() && time.t_in >= first_.lower && time.t_out >= first_.upper) return;
    first_ = {Verdict::touches, time.t_in, time.t_out};
  }

  Decision first_;
};

/// The end of every span of time in which the pair touches must be among the roots that hold, its start too: then
/// between two neighbours it touches always or never.
class FirstTimeOnceApart {
 public:
  /// As FirstTime: all roots for which `holds(time)`, each a time of touching.
  template <class Condition>
  void add_roots(const IntegerPolynomial& p, const Condition& holds) {
    TAMIS_ASSERT(!p.is_zero());
    for (AlgebraicTime& time : roots_in_unit_interval(p))
      if (holds(time)) times_.push_back(std::move(time));
  }

  /// The first time of touching before which there is one without, `touches(time)` telling both apart; at the start the
  /// pair may do either.
  template <class Condition>
  Decision decision(const Condition& touches) {
    AlgebraicTime start = AlgebraicTime::exactly({0, 0});
    for (AlgebraicTime *last = &start, *next = first_after(start); next; last = next, next = first_after(*last)) {
      if (touches(time_between(*last, *next))) continue;
      const auto [lower, upper] = next->bracket();
      return {Verdict::touches, lower, upper};
    }
    return {};
  }

 private:
  AlgebraicTime* first_after(AlgebraicTime& last) {
    AlgebraicTime* first = nullptr;
    for (AlgebraicTime& time : times_)
      if (compare(last, time) < 0 && (!first || compare(time, *first) < 0)) first = &time;
    return first;
  }

  std::vector<AlgebraicTime> times_;
};

}  // namespace tamis

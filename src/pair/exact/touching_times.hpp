// Collects times when a pair touches: roots of the polynomials of an exact decision. Finds the first of them, or the
// first recontact after the pair has separated.
#pragma once
#include <algorithm>
#include <utility>
#include <vector>

#include "pair/exact/root_isolation.hpp"
#include "pair/motion/decision.hpp"

namespace tamis {

class TouchingTimes {
 public:
  enum class Wanted { first, recontact };
  /// Times after `latest`, in [0,1], may be skipped.
  explicit TouchingTimes(Wanted wanted, double latest = 1) : wanted_(wanted), latest_(latest) {}

  /// Adds the roots of `p` in [0,1] for which `holds(time)`, each a time of touching. If only the first time of all is
  /// wanted, adds only the first such root. Of a polynomial that is always zero it adds none: such a polynomial begins
  /// and ends nothing.
  template <class Condition>
  void add_roots(const IntegerPolynomial& p, const Condition& holds) {
    if (p.is_zero()) return;
    for (AlgebraicTime& time : roots_in_unit_interval(p, latest_)) {
      if (latest_ < 1 && time.bracket().t_in > latest_) return;
      if (!holds(time)) continue;
      times_.push_back(std::move(time));
      if (wanted_ == Wanted::recontact) continue;
      latest_ = std::min(latest_, times_.back().bracket().t_out);
      return;
    }
  }

  /// The first time of touching. Times are compared by their brackets, which ascend with them. Only for pairs that are
  /// apart at t=0. A pair that moves within its plane may keep touching without any of these times.
  Decision first() const {
    Decision first;
    for (const AlgebraicTime& time : times_) {
      const auto [lower, upper] = time.bracket();
      if (first.is_free() || lower < first.lower || upper < first.upper) first = {Verdict::touches, lower, upper};
    }
    return first;
  }

  /// The first time of touching that a time without contact precedes. `touches(time)` decides single times. At the
  /// start the pair may touch or not. Both ends of every span of touching must be among the times. Then between two
  /// neighbours the pair touches always or never.
  template <class Condition>
  Decision first_recontact(const Condition& touches) {
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

  Wanted wanted_;
  double latest_;  ///< roots after it are not wanted
  std::vector<AlgebraicTime> times_;
};

}  // namespace tamis

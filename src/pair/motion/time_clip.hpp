// The ray-slab test in time: cuts from an interval all times at which some linear function (a gap) is positive. Serves
// boxes and pairs of features alike.
#pragma once
#include "numbers/error_bounds.hpp"
#include "numbers/select.hpp"

namespace tamis {

/// A part of the step; empty if t_in > t_out.
template <class T>
struct TimeInterval {
  T t_in, t_out;
};

/// Where an interval of times is halved: at no simple fraction. Contacts happen at simple fractions, and a contact at a
/// cut is undecided on both sides.
inline constexpr double kNearMiddle = 0.48713;
inline double near_middle(double from, double to) { return from + kNearMiddle * (to - from); }

/// True if the interval is neither empty nor beyond the step. Checked for doubles alone.
inline bool is_part_of_step(const TimeInterval<double>& time) {
  return 0 <= time.t_in && time.t_in <= time.t_out && time.t_out <= 1;
}
template <class T>
constexpr bool is_part_of_step(const TimeInterval<T>&) {
  return true;
}

template <class T>
class TimeClip {
 public:
  explicit TimeClip(const TimeInterval<T>& time) : time_(time) {}

  /// Cuts the times at which the line from g0 (t=0) to g1 (t=1) is positive. These are the times before its root if it
  /// falls, the times after it if it rises. If the root is outside the step, this cuts all or nothing, without a case
  /// of its own. A constant line has its root at +infinity (cut all), -infinity (nothing) or NaN (nothing).
  /// REQUIRES (not checked: exact): g0, g1 off by at most 2 u of themselves. NaN cuts nothing.
  void cut_positive(const T& g0, const T& g1) {
    const T fall = g0 - g1, root = Ratio<T>::of(g0, fall);
    const auto falls = fall >= T(0);
    first_ = Masked<T>::max_number(Masked<T>::zero_unless(falls, root), first_);
    last_ = Masked<T>::min_number(Masked<T>::nan_where(falls, root), last_);
  }

  /// The times that were not cut; t_out < t_in if there are none. A root is off, of itself, by the ratio's error, 4 u
  /// for the two ends, u for their difference and u for the product below; 8 u are given. The widening also keeps a
  /// root beyond the step's end beyond it.
  TimeInterval<T> rest() const {
    constexpr double kError = Ratio<T>::kError + 8 * error_bounds::unit_roundoff<T>;
    const T t_in = max(time_.t_in, first_ * constant<T>(1 - kError));
    const T t_out = min(time_.t_out, last_ * constant<T>(1 + kError));
    return {t_in, t_out};
  }

 private:
  TimeInterval<T> time_;
  T first_ = T(0), last_ = T(2);
};

}  // namespace tamis

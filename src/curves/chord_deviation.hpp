// How far a curve of bounded acceleration deviates from its chord.
#pragma once
#include "numerics/interval.hpp"

namespace tamis {

/// The deviation on a piece of this length, for an acceleration of 1.
inline Interval chord_factor(const Interval& length) { return Interval(0.125) * length * length; }
/// An upper bound of the deviation of a curve with |x''| <= acceleration.
inline double chord_deviation(double acceleration, const Interval& length) {
  return (chord_factor(length) * Interval(acceleration)).upper;
}

}  // namespace tamis

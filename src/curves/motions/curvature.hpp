// How far a curve bends, and so deviates from its chords.
#pragma once
#include <algorithm>
#include <limits>

#include "numbers/interval.hpp"

namespace tamis {

/// The deviation on a piece of this length, over the acceleration.
inline Interval chord_factor(const Interval& length) { return Interval(0.125) * length * length; }

/// Bounds of how far one point's curve bends.
struct Curvature {
  double acceleration;  ///< |x''| is at most this
  /// x(t), less its part that moves linearly, stays within this distance of one point.
  double orbit_radius = std::numeric_limits<double>::infinity();

  /// An upper bound of the distance from the chord, on a piece whose chord_factor() is `factor`.
  double deviation(const Interval& factor) const {
    return std::min((factor * Interval(acceleration)).upper, 2 * orbit_radius);
  }
};

}  // namespace tamis

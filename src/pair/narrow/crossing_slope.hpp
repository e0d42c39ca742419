// Tells whether the coplanarity of a pair rises or falls during a time. Where it does either, it has one root there at
// most.
#pragma once
#include <cmath>

#include "numbers/error_bounds.hpp"
#include "pair/motion/polynomials.hpp"
#include "pair/motion/time_clip.hpp"
#include "pair/narrow/crossing_root.hpp"

namespace tamis::crossing {

/// A lower bound of the size of the coplanarity's slope during all of `time`, with the sign of that slope; 0 if the
/// sign is not certain. REQUIRES: the motion of a whole step.
inline double least_slope_during(const PairMotion<double>& m, const TimeInterval<double>& time) {
  TAMIS_ASSERT(is_whole(m) && is_part_of_step(time));
  const double unit = m.size_d * m.size_e * m.size_f, middle = 0.5 * (time.t_in + time.t_out);
  const double value = slope(coplanarity_polynomial(m), middle);
  // The slope changes by at most 2 kBend a unit of time.
  const double error = error_bounds::bound(error_bounds::kCoplanaritySlope, unit) +
                       2 * error_bounds::kBend * (time.t_out - time.t_in) * unit;
  const double least = std::fabs(value) - error;
  return least > 0 ? std::copysign(least / kRoundedUp, value) : 0;
}

}  // namespace tamis::crossing

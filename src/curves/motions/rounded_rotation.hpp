// Rotations in doubles with bounds of their errors. Positions of bodies on curves are computed from these.
#pragma once
#include <array>

#include "tamis/contact.hpp"

namespace tamis {

struct RoundedRotation {
  std::array<Point, 3> rows;
  double error;  ///< no entry is off by more
};

/// In radians. A larger angle would need cosine and sine of a small angle doubled twice. Each doubling loses bits.
inline constexpr double kLargestRoundedAngle = 4;

/// The rotation by the vector `rotation`. Its direction is the axis, its length the angle. Also a bound of its distance
/// from the rotation by the true vector, which is at most `off` from `rotation`. Proof: docs/numerics/curves.md, "Sine
/// and cosine". REQUIRES: `rotation` is no longer than kLargestRoundedAngle, but for rounding.
RoundedRotation rounded_rotation(const Point& rotation, double off);

}  // namespace tamis

// Rotations in doubles, and what they are off by: where bodies on curves are is computed from these.
#pragma once
#include <array>

#include "tamis/contact.hpp"

namespace tamis {

struct RoundedRotation {
  std::array<Point, 3> rows;
  double error;  ///< no entry is off by more
};

/// Beyond, cosine and sine would be doubled twice from those of a small angle, and lose as many bits.
inline constexpr double kLargestRoundedAngle = 4;

/// By a rotation vector (its direction the axis, its length the angle) from which the true one is no farther than
/// `off`. Proof of the error: docs/numerics.md, "Sine and cosine". REQUIRES: no longer than kLargestRoundedAngle, but
/// for rounding.
RoundedRotation rounded_rotation(const Point& rotation, double off);

}  // namespace tamis

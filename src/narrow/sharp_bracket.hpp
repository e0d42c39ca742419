// When the bracket of a contact is narrow enough.
#pragma once
#include "numerics/select.hpp"

namespace tamis {

/// `earliest` looks at every contact that starts up to this factor after the end of another one: no sharp bracket is so
/// wide that the first of two could be lost to rounding.
inline constexpr double kNearTie = 1 + 0x1p-16;

/// Is this bracket of a certified contact good enough? Wider ones, and ones that leave undecided whether the pair
/// touches at t=0, are sharpened in double-double, or by exact algebra: where the coplanarity cubic is nearly flat,
/// doubles know its root to few digits. For double and for SIMD lanes. Narrower than 1e-11, and than a twentieth of
/// kNearTie: a pair that touches after it has a bracket that begins later.
template <class T>
inline auto is_sharp(const T& toi_lower, const T& toi_upper) {
  const T widest = min(T(1e-11), T(0.05 * (kNearTie - 1)) * toi_upper);
  return (toi_upper - toi_lower <= widest) & ((toi_lower > T(0)) | (toi_upper == T(0)));
}

}  // namespace tamis

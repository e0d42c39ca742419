// When the bracket of a contact is narrow enough.
#pragma once
#include <algorithm>

#include "numbers/select.hpp"

namespace tamis {

/// `earliest` looks at every contact that starts up to this factor, and up to kNearTieTime, after the end of another
/// contact. Sharp brackets are narrower, so rounding cannot hide which of two contacts is first.
inline constexpr double kNearTie = 1 + 0x1p-16, kNearTieTime = 2e-11;

/// The latest time of interest after a contact that ends so. The bracket of a pair that touches later begins after
/// `toi_upper` by more than 2^-37 of it (FirstContact).
inline double near_tie(double toi_upper) { return std::min(toi_upper * kNearTie, toi_upper + kNearTieTime); }

/// True if this bracket of a certified contact is good enough. It must be narrower than 1e-11, and than a twentieth of
/// the time that kNearTie adds. Then a pair that touches so much later has a bracket that begins later. Double-double,
/// or exact algebra, sharpens wider brackets. It also sharpens brackets that do not tell whether the pair touches at
/// t=0. Doubles know few digits of a root where the coplanarity cubic is nearly flat. For double and for SIMD lanes.
template <class T>
inline auto is_sharp(const T& toi_lower, const T& toi_upper) {
  const T widest = min(T(1e-11), T(0.05 * (kNearTie - 1)) * toi_upper);
  return (toi_upper - toi_lower <= widest) & ((toi_lower > T(0)) | (toi_upper == T(0)));
}

}  // namespace tamis

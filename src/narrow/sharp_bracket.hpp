// When the bracket of a contact is narrow enough.
#pragma once

namespace tamis {

/// Is this bracket of a certified contact good enough? Wider ones, and ones that leave undecided whether the pair
/// touches at t=0, are sharpened by exact algebra: where the coplanarity cubic is nearly flat, doubles know its root to
/// few digits. For double and for SIMD lanes.
template <class T>
inline auto is_sharp(const T& toi_lower, const T& toi_upper) {
  return (toi_upper - toi_lower <= T(1e-11)) & ((toi_lower > T(0)) | (toi_upper == T(0)));
}

}  // namespace tamis

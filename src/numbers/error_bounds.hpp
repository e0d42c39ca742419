// Every rounding-error constant of the double-precision culling and solving, with its derivation in short. The long
// form is in docs/numerics/one-pair.md. Unit: the roundoff u of the number type, times the product of the sizes of the
// vectors involved.
//
// A pair is three moving vectors e, f, d. Their sizes E, F, D are the largest |component| at t=0 and t=1. All are
// scaled by a power of two so the largest size is below 1 (pair/motion/pair_motion.hpp).
#pragma once
#include "numbers/platform.hpp"
#include "numbers/select.hpp"

namespace tamis::error_bounds {

/// The u of a number type. A sum or a product is off by at most u of itself. Each type specializes it beside its
/// operations. A type without its own u must not compile: it would pass for double.
template <class T>
inline constexpr double unit_roundoff = [] {
  static_assert(sizeof(T) == 0, "this number type does not say its unit roundoff");
  return 0.0;
}();
template <>
inline constexpr double unit_roundoff<double> = 0x1p-53;
inline constexpr double kRoundoff = unit_roundoff<double>;

/// Added to every bound. Products that underflow are wrong by at most 2^-1075 each, after fewer than 2^10 operations on
/// numbers below 2^7.
template <class T>
inline constexpr double underflow = 0x1p-1000;

/// The bound `factor` u `unit`, underflow included.
template <class T>
inline T bound(double factor, const T& unit) {
  return constant<T>(factor * unit_roundoff<T>) * unit + constant<T>(underflow<T>);
}

/// A component of a vector, or of a sum of two, is off by at most 8 u times its size, rounded up. 1 u comes from the
/// subtraction of the positions, 3 u from restricting the motion to a part of the step, 1 u from the sum.
inline constexpr double kInput = 8;

// Coplanarity K = d.(e x f), unit D E F. N0, N2: 4 kInput + 4 = 36, |N0| <= 2; N1: 76, |N1| <= 4. K0, K3: 3 (2 kInput +
// 36 + 2) + 10 = 172. K1, K2: 3 (4 kInput + 76 + 4) + 20 + 172 + 18 = 546. The cubic of the whole step, restricted to
// the part, is off by less. With kInput = 1, N is off by 8 and 20, K0 and K3 by 46, K1 and K2 by 168, as are 3 K0 and 3
// K3. These four are at most 18. So each of three mixtures adds 3 * 18. That makes 330; a third is 110, and 122 with
// its rounding.
inline constexpr double kCoplanarityEnd = 180;
inline constexpr double kCoplanarityMiddle = 560;

// Side of an edge plane S = x.(w x n), n = e x f, unit X W E F, for the edge's direction w and a point's difference x.
// M0, M3: 2 (2 kInput + 36 + 2) + 4 = 112, |M0| <= 4; M1, M2: 2 (4 kInput + 76 + 4) + 8 + 112 + 12 = 356, |M1| <= 12.
// S0, S4: 3 (4 kInput + 112 + 4) + 20 = 464; S1, S3: 3 (12 kInput + 356 + 12) + 60 + 464 + 48 = 1964;
// S2: 2 * 1452 + 72 = 2976.
inline constexpr double kSideEnd = 480;
inline constexpr double kSideNext = 2000;
inline constexpr double kSideMiddle = 3000;

// The value of K from the vectors at one time of the whole step, same unit. Positions and at_time 1 + 3 = 4 each, N 2
// (2 * 4 + 1) + 2 = 20 with |N| <= 2, K 3 (2 * 4 + 20 + 2) + 4 + 6 = 100.
inline constexpr double kCoplanarityNow = 104;

// The slope of K over a part of [0,1], same unit. Its Bernstein coefficients are k1 - 3 k0, k2 - k1, 3 k3 - k2, below
// 36. Two are off by at most 3 * 180 + 560 + 2 * 36 = 1172 u, the middle one by 2 * 560 + 36 = 1156 u. Their average
// with weights that add up to 1 rounds by less than 8 * 36 = 288 u.
inline constexpr double kCoplanaritySlope = 1600;

// From a value of K at time t to a value at t + r, in the unit of time of a part of the step. K'' = 2 (d'.(e' x f) +
// d'.(e x f') + d.(e' x f')) is at most 2 * 3 * 6 * 2 * 2 = 144 DEF. So K changes by K' r and by at most kBend r^2 DEF.
// K' at the place of t in the part, which is known to 3 u of the step: off by kCoplanaritySlope + 3 * 144.
inline constexpr double kBend = 72;
inline constexpr double kCoplanaritySlopeNow = 2100;

// The value of S from vectors at one time (3 u more than kInput each, see at_time). As S0 with kInput = 12:
// N 52, M 2 (2*12 + 52 + 2) + 4 = 160, S 3 (4*12 + 160 + 4) + 20 = 656.
inline constexpr double kSideValue = 700;
// Within a time r of there, S changes by at most 12 r times a sum over its four factors, because |S| <= 12 X W E F. The
// term of a factor is its change times the sizes of the others. No factor changes by more than twice its size: 12 * 4 *
// 2 = 96 times r X W E F.
inline constexpr double kSideSlope = 97;

// A difference projected on an axis with components in {-1,0,1}, unit D + E + F: 3 (kInput + 3) + 2 * 3 = 39.
inline constexpr double kProjection = 48;

// A corner of the two features' difference (a sum of up to three of e, f, d) on an axis that turns, beyond the
// separation. Unit D + E + F. The separation is at most 3 (D + E + F), or nothing is proven. The axis has components up
// to 1, its turn r. At the time in question: 6 from positions, sums and at_time, so 3 (6 + 1) + 5 = 26, and the
// subtraction 3.
inline constexpr double kAxisNow = 32;
// The addition after a time x with r x <= 1, unit x (1 + r). Velocities of size 2 are off by 8, so on the axis 3 (8 +
// 2) + 10 = 40, and as much on its turn. Sums 24. The axis' turn on the corner 26, on the separation 72 + 36, sums 41.
// In all below 104 + 175 r.
inline constexpr double kAxisLater = 192;

// The gap between a point of each feature, both given by weights, at a time in [0,1]. Unit D + E + F, all components
// together. Vectors at that time 1 + 3, products 1, sums 2, so sqrt(3) * 7 = 12.2. Weights whose sum rounds to 1 add 2.
inline constexpr double kGap = 20;

// By how much the distance at rest by closest points may exceed the bound along their axis, unit D + E + F. Rounding
// makes 88 of that where the axis is the right one: kGap above, kAxisNow below, kLength and 8 of a length below 3. A
// tilted axis may cost up to ten times that. If it costs more, integers find the distance.
inline constexpr double kRestDistance = 1024;

// The velocity of a corner of the two features' difference. Unit D + E + F, all components together. At each end kInput
// and two sums 2, their difference (below 2) 2 more: 22 a component, sqrt(3) * 22 = 38.2.
inline constexpr double kVelocity = 40;

// How fast a corner gains along an axis with components up to 1 that turns by r. Unit (D + E + F) (1 + r). The
// velocity: sqrt(3) * 38.2 = 66.2. Three products and two sums of numbers that are at most 6 together: 18. The turn on
// the corner: 26 r, as in kAxisNow, and 6 r. The turn on the axis, times a distance of at most 3: 27 r. Sums: 6 + 6 r.
// In all below 91 + 65 r.
inline constexpr double kGrowth = 128;

// Length of a vector, unit: itself: squares 1/2, two sums 1, root 1, all below 4.
inline constexpr double kLength = 4;
/// A computed length times this is no less than the length.
inline constexpr double kLengthUp = 1 + kLength * unit_roundoff<double>;

// A pair's distance along an axis between two unit vectors, beyond a least distance. Unit D + E + F. A corner on the
// axis is three products of a factor off by kInput + 4, and sums: 57. Halves and sums: 4. The axis' length 5 and the
// least distance 4, of at most 3: 27. Together 88.
inline constexpr double kTurningGap = 96;
// The same, where the least distance is a part of that at t=0: kGap and kLength, 27 more.
inline constexpr double kKeptGap = 128;

// A part of D + E + F. Advancement (pair/narrow/first_within.hpp) continues while a pair's clearance exceeds it. Each
// advance is at least 1/16 of this part of the step (docs/numerics/steps.md, "Step lengths").
inline constexpr double kAdvanceClearance = 0x1p-10;

// The same for every pair within two boxes, times X. X is the largest extent along an axis from the lower end of one
// box to the upper end of the other. D is at most X, and each box is at most 2 X wide. The sides of a face are in one
// box, so E + F is at most 4 X. 6 covers all other rounding.
inline constexpr double kBoxAdvanceClearance = 6 * kAdvanceClearance;

}  // namespace tamis::error_bounds

namespace tamis {

/// The result of sums, products, quotients and roots of doubles >= 0, times this, is no less than without rounding.
/// Each loses at most u of itself, and 2^12 of them lose less than this adds. Callers add a term for underflow.
inline constexpr double kRoundedUp = 1 + 0x1p-40;

}  // namespace tamis

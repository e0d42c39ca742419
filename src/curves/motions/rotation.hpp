// Rotations (Rodrigues): R = cos 1 + a [w]x + b w w^T for a rotation vector w of length phi. a = sin phi / phi and b =
// (1 - cos phi) / phi^2 are smooth at zero. Here intervals of double-double enclose them;
// curves/motions/rounded_rotation.hpp computes in doubles.
#pragma once
#include <array>

#include "numbers/interval.hpp"
#include "numbers/vec.hpp"

namespace tamis::rotation {

/// cos phi and sin phi / phi.
template <class T>
struct CosineSinc {
  T cosine, sinc;
};

/// The rows of R, from the rows for half the angle.
template <class T>
std::array<Vec3<T>, 3> rows_of(const Vec3<T>& w, const CosineSinc<T>& half) {
  const T a = half.sinc * half.cosine, b = T(0.5) * half.sinc * half.sinc;
  const T one(1), xx = b * w.x * w.x, yy = b * w.y * w.y, zz = b * w.z * w.z;
  const T xy = b * w.x * w.y, xz = b * w.x * w.z, yz = b * w.y * w.z;
  return {{{one - (yy + zz), xy - a * w.z, xz + a * w.y},
           {xy + a * w.z, one - (xx + zz), yz - a * w.x},
           {xz - a * w.y, yz + a * w.x, one - (xx + yy)}}};
}

/// From the square of phi, in [0, 1], by the alternating series. Its terms fall. So the rest after any term lies
/// between 0 and the next term. No promise of a library's sine is needed.
inline CosineSinc<FineInterval> small_angle(const FineInterval& square) {
  constexpr int kTerms = 16;  // 32! > 2^117
  const FineInterval one(1), some(DoubleDouble(0), DoubleDouble(1));
  CosineSinc<FineInterval> result{some, some};
  for (int k = kTerms - 1; k >= 0; --k) {
    result.cosine = one - square / FineInterval((2.0 * k + 1) * (2.0 * k + 2)) * result.cosine;
    result.sinc = one - square / FineInterval((2.0 * k + 2) * (2.0 * k + 3)) * result.sinc;
  }
  return result;
}

/// Any angle. It is halved until it is small, then doubled again: cos 2x = 2 cos^2 x - 1, sin 2x / 2x = (sin x / x) cos
/// x.
inline CosineSinc<FineInterval> any_angle(FineInterval square) {
  constexpr int kMostHalvings = 500;
  const FineInterval one(1), two(2), quarter(0.25), unknown(DoubleDouble(-1), DoubleDouble(1));
  int halvings = 0;
  for (; square.upper > DoubleDouble(1) && halvings < kMostHalvings; ++halvings) square = quarter * square;
  if (!(square.upper <= DoubleDouble(1))) return {unknown, unknown};
  CosineSinc<FineInterval> result = small_angle(square);
  for (; halvings > 0; --halvings) result = {two * result.cosine * result.cosine - one, result.sinc * result.cosine};
  return result;
}

using Rows = std::array<Vec3<FineInterval>, 3>;

inline Rows identity() {
  const FineInterval one(1), zero(0);
  return {{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}};
}

inline Rows matrix(const Vec3<FineInterval>& w) {
  if (is_zero(w)) return identity();
  return rows_of(w, any_angle(FineInterval(0.25) * dot(w, w)));
}

}  // namespace tamis::rotation

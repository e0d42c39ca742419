// Rotations enclosed by intervals: R = cos 1 + a [w]x + b w w^T for a rotation vector w of length phi, with
// a = sin phi / phi and b = (1 - cos phi) / phi^2, which are smooth at zero (Rodrigues).
#pragma once
#include <array>

#include "numerics/interval.hpp"
#include "numerics/vec.hpp"

namespace tamis::rotation {

/// cos phi and sin phi / phi.
template <class T>
struct CosineSinc {
  BasicInterval<T> cosine, sinc;
};

/// From the square of phi, by the alternating series: with square <= 1 the terms fall, so that what follows any term
/// is between nothing and all of the next one. No promise of a library's sine is needed.
template <class T>
CosineSinc<T> small_angle(const BasicInterval<T>& square) {
  using I = BasicInterval<T>;
  constexpr int kTerms = sizeof(T) > sizeof(double) ? 16 : 10;  // 32! > 2^117, 20! > 2^61
  I cosine(T(0), T(1)), sinc(T(0), T(1));
  for (int k = kTerms - 1; k >= 0; --k) {
    cosine = I(T(1)) - square / I(T((2.0 * k + 1) * (2.0 * k + 2))) * cosine;
    sinc = I(T(1)) - square / I(T((2.0 * k + 2) * (2.0 * k + 3))) * sinc;
  }
  return {cosine, sinc};
}

/// Any angle: halved until it is small, then doubled again: cos 2x = 2 cos^2 x - 1, sin 2x / 2x = (sin x / x) cos x.
template <class T>
CosineSinc<T> any_angle(BasicInterval<T> square) {
  using I = BasicInterval<T>;
  constexpr int kMostHalvings = 500;
  int halvings = 0;
  for (; square.upper > T(1) && halvings < kMostHalvings; ++halvings) square = I(T(0.25)) * square;
  if (!(square.upper <= T(1))) return {I(T(-1), T(1)), I(T(-1), T(1))};
  CosineSinc<T> result = small_angle(square);
  for (; halvings > 0; --halvings)
    result = {I(T(2)) * result.cosine * result.cosine - I(T(1)), result.sinc * result.cosine};
  return result;
}

template <class T>
using Rows = std::array<Vec3<BasicInterval<T>>, 3>;

template <class T>
Rows<T> identity() {
  using I = BasicInterval<T>;
  const I one(T(1)), zero(T(0));
  return {{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}};
}

template <class T>
Rows<T> matrix(const Vec3<BasicInterval<T>>& w) {
  using I = BasicInterval<T>;
  if (is_zero(w)) return identity<T>();
  const I square = dot(w, w);
  const auto half = any_angle(I(T(0.25)) * square);
  const I a = half.sinc * half.cosine, b = I(T(0.5)) * half.sinc * half.sinc;
  const I one(T(1)), xx = b * w.x * w.x, yy = b * w.y * w.y, zz = b * w.z * w.z;
  const I xy = b * w.x * w.y, xz = b * w.x * w.z, yz = b * w.y * w.z;
  return {{{one - (yy + zz), xy - a * w.z, xz + a * w.y},
           {xy + a * w.z, one - (xx + zz), yz - a * w.x},
           {xz - a * w.y, yz + a * w.x, one - (xx + yy)}}};
}

}  // namespace tamis::rotation

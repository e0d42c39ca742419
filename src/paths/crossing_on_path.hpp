// A crossing on a piece of a path: which sign the coplanarity has at its ends, and where it passes zero.
#pragma once
#include "narrow/crossing.hpp"
#include "numerics/assert.hpp"
#include "paths/chords.hpp"

namespace tamis {

/// Of an interval: 0 if that is not known.
template <class T>
int sign_of(const BasicInterval<T>& x) {
  return x.lower > T(0) ? 1 : x.upper < T(0) ? -1 : 0;
}

struct PathCrossing {
  int sign_at_start = 0, sign_at_end = 0;
  bool is_opposite() const { return sign_at_start * sign_at_end < 0; }
};

template <class T>
PathCrossing crossing_of(const PairMotion<BasicInterval<T>>& ends) {
  return {sign_of(dot(ends.d.at0, cross(ends.e.at0, ends.f.at0))),
          sign_of(dot(ends.d.at1, cross(ends.e.at1, ends.f.at1)))};
}

/// A part of [0,1], in the unit of the piece, around the place where the chords cross, as narrow as the deviations
/// allow; a guess, which nothing relies on. REQUIRES: a sign, -1 or 1. REQUIRES (not checked: history): the other at
/// the end.
template <class T>
TimeInterval<double> window_of(const PairMotion<BasicInterval<T>>& widened, int sign_at_start) {
  TAMIS_ASSERT(sign_at_start == 1 || sign_at_start == -1);
  const auto k = coplanarity_polynomial(widened.d, normal_polynomial(widened.e, widened.f));
  std::array<double, 4> middle{};
  double width = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double weight = i == 0 || i == 3 ? 1 : 3;  // k[1], k[2] are 3 times the Bernstein coefficients
    middle[i] = sign_at_start * nearest_double(k[i].middle());
    width = max(width, farthest_from(k[i].middle(), k[i]) / weight);
  }
  const double root = crossing::find_root(middle), slope = abs(crossing::slope(middle, root));
  const double margin = 2 * width / slope + 0x1p-48;
  return {root - margin, root + margin};
}

}  // namespace tamis

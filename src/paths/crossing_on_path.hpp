// A crossing on a piece of a path: which sign the coplanarity has at its ends, and where it passes zero.
#pragma once
#include "narrow/crossing.hpp"
#include "numerics/assert.hpp"
#include "paths/chords.hpp"

namespace tamis {

/// The sign of the coplanarity at one time: 0 if that is not known.
template <class T>
int side_of(const Vec3<BasicInterval<T>>& e, const Vec3<BasicInterval<T>>& f, const Vec3<BasicInterval<T>>& d) {
  const BasicInterval<T> k = dot(d, cross(e, f));
  return k.lower > T(0) ? 1 : k.upper < T(0) ? -1 : 0;
}

/// The side at the start, of a pair that is on the other one at the end; 0: that is not known.
template <class T>
int side_before_crossing(const PairMotion<BasicInterval<T>>& ends) {
  const int start = side_of(ends.e.at0, ends.f.at0, ends.d.at0), end = side_of(ends.e.at1, ends.f.at1, ends.d.at1);
  return start * end < 0 ? start : 0;
}

/// A part of [0,1], in the unit of the piece, around the place where the chords cross, as narrow as the deviations
/// allow; a guess, which nothing relies on. REQUIRES: a side, -1 or 1. REQUIRES (not checked: history): the other at
/// the end.
template <class T>
TimeInterval<double> window_of(const PairMotion<BasicInterval<T>>& widened, int side_at_start) {
  TAMIS_ASSERT(side_at_start == 1 || side_at_start == -1);
  const auto k = coplanarity_polynomial(widened);
  std::array<double, 4> middle{};
  double width = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double weight = i == 0 || i == 3 ? 1 : 3;  // k[1], k[2] are 3 times the Bernstein coefficients
    middle[i] = side_at_start * nearest_double(k[i].middle());
    width = max(width, farthest_from(k[i].middle(), k[i]) / weight);
  }
  const double root = crossing::find_root(middle), slope = abs(crossing::slope(middle, root));
  const double margin = 2 * width / slope + 0x1p-48;
  return {root - margin, root + margin};
}

}  // namespace tamis

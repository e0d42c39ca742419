#include "narrow/far_flight.hpp"

#include <algorithm>
#include <cmath>

#include "narrow/separation.hpp"
#include "numerics/assert.hpp"

namespace tamis {
namespace {

/// The part of the step, a power of two, in which the pair flies some sixteen times as far as it is large at the start;
/// zero unless that is short.
double part_of_beginning(const PairMotion<double>& m) {
  constexpr double kShort = 0x1p-20;
  constexpr int kFarther = 5, kLeastExponent = -1020;
  const auto at_start = [](const Moving<double>& v) { return largest(Moving<double>{v.at0, v.at0}); };
  const double size = std::max({at_start(m.e), at_start(m.f), at_start(m.d), m.separation});
  if (!(size > 0 && size < kShort)) return 0;
  return std::ldexp(1, std::max(std::ilogb(size) + kFarther, kLeastExponent));
}

}  // namespace

bool flies_past(PairKind kind, const PairPoints& points, double separation, const PairMotion<double>& m) {
  TAMIS_ASSERT(is_motion_of(m, kind, points) && is_finite(m));
  const double part = part_of_beginning(m);
  if (part == 0) return false;
  const auto beginning = make_beginning(kind, points, separation, part);
  return beginning && is_apart_from_end(kind, *beginning) && first_within(kind, *beginning, {0, 1}).is_free();
}

}  // namespace tamis

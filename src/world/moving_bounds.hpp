// Boxes of a world that move from one place to another.
#pragma once
#include "bounds/box.hpp"

namespace tamis {

/// Goes straight from `start` to `end`. Each is wider than what it holds by kRounding of its size: that is for the
/// rounding of `may_meet`.
struct MovingBounds {
  Box start, end;

  static constexpr double kRounding = 0x1p-44;

  Box hull() const {
    Box hull = start;
    hull.include(end);
    return hull;
  }
};

/// Do they come within `separation` at one time? False only if proven: the gap along one axis is open, or those along
/// several are at times between them. What is not a number proves nothing.
inline bool may_meet(const MovingBounds& a, const MovingBounds& b, double separation) {
  constexpr double kRoundingOfTimes = 0x1p-40;
  double from = 0, to = 1;
  const auto close = [&](double gap0, double gap1) {
    if (!(gap0 > 0 || gap1 > 0)) return true;
    if (gap0 > 0 && gap1 > 0) return false;
    // Where a difference overflows these are 0 and 1, which prove nothing.
    if (gap0 > 0) from = std::max(from, gap0 / (gap0 - gap1));
    if (gap1 > 0) to = std::min(to, 1 - gap1 / (gap1 - gap0));
    return true;
  };
  for (std::size_t k = 0; k < 3; ++k) {
    if (!close(a.start.low[k] - b.start.high[k] - separation, a.end.low[k] - b.end.high[k] - separation)) return false;
    if (!close(b.start.low[k] - a.start.high[k] - separation, b.end.low[k] - a.end.high[k] - separation)) return false;
  }
  return !(from > to + kRoundingOfTimes);
}

}  // namespace tamis

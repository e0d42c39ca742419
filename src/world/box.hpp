// Boxes of a world: at rest, and moving from one place to another.
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "tamis/contact.hpp"

namespace tamis {

inline constexpr double kEverywhere = std::numeric_limits<double>::infinity();

struct Box {
  /// Empty at first: includes nothing.
  Point low{kEverywhere, kEverywhere, kEverywhere};
  Point high{-kEverywhere, -kEverywhere, -kEverywhere};

  void include(const Point& point) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], point[k]);
      high[k] = std::max(high[k], point[k]);
    }
  }
  void include(const Box& other) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], other.low[k]);
      high[k] = std::max(high[k], other.high[k]);
    }
  }
  void widen(double by) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] -= by;
      high[k] += by;
    }
  }
  /// The largest |coordinate|.
  double size() const {
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k) size = std::max({size, std::fabs(low[k]), std::fabs(high[k])});
    return size;
  }
  /// No |x|_1 within is larger.
  double size_of_sum() const {
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k) size += std::max(std::fabs(low[k]), std::fabs(high[k]));
    return size * (1 + 0x1p-50);
  }
  /// How far it reaches along all axes together.
  double extent() const { return high[0] - low[0] + (high[1] - low[1]) + (high[2] - low[2]); }
  /// The center, but for rounding.
  Point middle() const {
    return {0.5 * low[0] + 0.5 * high[0], 0.5 * low[1] + 0.5 * high[1], 0.5 * low[2] + 0.5 * high[2]};
  }
};

/// False only if proven.
inline bool may_meet(const Box& a, const Box& b) {
  bool is_apart = false;
  for (std::size_t k = 0; k < 3; ++k) is_apart |= a.low[k] > b.high[k] || b.low[k] > a.high[k];
  return !is_apart;
}

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

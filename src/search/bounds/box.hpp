// An axis-aligned box in doubles.
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "tamis/contact.hpp"

namespace tamis {

inline constexpr double kUnbounded = std::numeric_limits<double>::infinity();

struct Box {
  // Empty at first.
  Point low{kUnbounded, kUnbounded, kUnbounded};
  Point high{-kUnbounded, -kUnbounded, -kUnbounded};

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
  double largest_coordinate() const {
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k) size = std::max({size, std::fabs(low[k]), std::fabs(high[k])});
    return size;
  }
  /// An upper bound of |x|_1 within the box.
  double largest_sum() const {
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k) size += std::max(std::fabs(low[k]), std::fabs(high[k]));
    return size * (1 + 0x1p-50);
  }
  /// The sum of its lengths along the axes.
  double extent() const { return high[0] - low[0] + (high[1] - low[1]) + (high[2] - low[2]); }
  /// Half of its length along the widest axis. Unlike the whole length, it does not overflow.
  double half_width() const {
    double half = 0;
    for (std::size_t k = 0; k < 3; ++k) half = std::max(half, 0.5 * high[k] - 0.5 * low[k]);
    return half;
  }
  /// The center, rounded.
  Point middle() const {
    return {0.5 * low[0] + 0.5 * high[0], 0.5 * low[1] + 0.5 * high[1], 0.5 * low[2] + 0.5 * high[2]};
  }
};

inline Box joined(Box a, const Box& b) {
  a.include(b);
  return a;
}

/// False only if they are proven apart; NaN proves nothing.
inline bool may_meet(const Box& a, const Box& b) {
  bool is_apart = false;
  for (std::size_t k = 0; k < 3; ++k) is_apart |= a.low[k] > b.high[k] || b.low[k] > a.high[k];
  return !is_apart;
}

}  // namespace tamis

// A box in doubles: what holds some points.
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
  /// Half of the widest axis: it does not overflow.
  double half() const {
    double half = 0;
    for (std::size_t k = 0; k < 3; ++k) half = std::max(half, 0.5 * high[k] - 0.5 * low[k]);
    return half;
  }
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

}  // namespace tamis

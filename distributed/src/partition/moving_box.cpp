#include "distributed/src/partition/moving_box.hpp"

#include <algorithm>
#include <cmath>

namespace tamis::distributed {
namespace {

/// Widens by at least `distance`, whatever the rounding.
void widen(Box& box, double distance) {
  if (distance == 0) return;
  const double more = std::nextafter(distance * (1 + 0x1p-40), kUnbounded);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.low[axis] = std::nextafter(box.low[axis] - more, -kUnbounded);
    box.high[axis] = std::nextafter(box.high[axis] + more, kUnbounded);
  }
}

Point drift_of(const Motion& motion) {
  return {motion.end[0] - motion.start[0], motion.end[1] - motion.start[1], motion.end[2] - motion.start[2]};
}

/// Widens by more than the subtraction's rounding.
void widen_drifts(Box& box) {
  constexpr double kRounding = 0x1p-51;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.low[axis] -= kRounding * std::fabs(box.low[axis]);
    box.high[axis] += kRounding * std::fabs(box.high[axis]);
  }
}

/// The times at which two boxes may still meet.
struct Times {
  double first, last;

  /// Leaves out the times at which the line from `at0` to `at1` is positive. The line's zero is off by less than 2^-40
  /// in time, as both ends are rounded once. NaN leaves out nothing. Where the difference overflows, the quotients are
  /// 0, which leave out nothing either.
  void leave_out_positive(double at0, double at1) {
    constexpr double kErrorOfTime = 0x1p-40;
    if (at0 > 0 && at1 > 0) last = -1;
    if (at0 > 0 && at1 <= 0) first = std::max(first, at0 / (at0 - at1) - kErrorOfTime);
    if (at0 <= 0 && at1 > 0) last = std::min(last, 1 - at1 / (at1 - at0) + kErrorOfTime);
  }
};

double extent(const Box& a, const Box& b, std::size_t axis) {
  return std::max(a.high[axis], b.high[axis]) - std::min(a.low[axis], b.low[axis]);
}

}  // namespace

std::vector<MovingBox> boxes_of(const ElementSet& set, const BoxRule& rule) {
  std::vector<MovingBox> boxes;
  boxes.reserve(set.elements.size());
  for (const Corners& corners : set.elements) {
    MovingBox box;
    double radius = 0;
    for_each_corner(corners, [&](std::size_t v) {
      const Motion& motion = set.motions[v];
      box.start.include(motion.start);
      box.other.include(rule.has_drifts ? drift_of(motion) : motion.end);
      if (!rule.radius_of_group.empty())
        radius = std::max(radius, rule.radius_of_group[static_cast<std::size_t>(set.vertices[v].group)]);
    });
    const double distance = radius + 0.5 * rule.min_separation;
    widen(box.start, rule.min_separation > 0 ? std::nextafter(distance, kUnbounded) : distance);
    if (rule.has_drifts)
      widen_drifts(box.other);
    else
      widen(box.other, rule.min_separation > 0 ? std::nextafter(distance, kUnbounded) : distance);
    boxes.push_back(box);
  }
  return boxes;
}

bool MeetUntil::operator()(const MovingBox& a, const MovingBox& b) const {
  Times times{0, time};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    times.leave_out_positive(b.start.low[axis] - a.start.high[axis], b.other.low[axis] - a.other.high[axis]);
    times.leave_out_positive(a.start.low[axis] - b.start.high[axis], a.other.low[axis] - b.other.high[axis]);
  }
  return times.first <= times.last;
}

bool NearWithin::operator()(const MovingBox& a, const MovingBox& b) const {
  // The speed of a pair is rounded up by less than 2^-44 of its extents (error_bounds::kVelocity, three sizes).
  constexpr double kSpeedMargin = 0x1p-44, kRounding = 1 + 0x1p-20;
  Point gap, way;
  double size = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto apart = [axis](const Box& p, const Box& q) {
      return std::max(q.low[axis] - p.high[axis], p.low[axis] - q.high[axis]);
    };
    gap[axis] = std::max(apart(a.start, b.start), 0.0);
    way[axis] = std::max(a.other.high[axis] - b.other.low[axis], b.other.high[axis] - a.other.low[axis]);
    const double drift = std::max(std::fabs(a.other.low[axis]), std::fabs(a.other.high[axis])) +
                         std::max(std::fabs(b.other.low[axis]), std::fabs(b.other.high[axis]));
    size = std::max(size, extent(a.start, b.start, axis) + drift);
  }
  const double speed = std::hypot(way[0], way[1], way[2]) + kSpeedMargin * size;
  return !(std::hypot(gap[0], gap[1], gap[2]) > reach * speed * kRounding);
}

}  // namespace tamis::distributed

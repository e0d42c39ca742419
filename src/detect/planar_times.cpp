#include "detect/planar_times.hpp"

#include <cmath>

#include "motion/pair_kinds.hpp"
#include "narrow/near_pair.hpp"
#include "topology/points.hpp"

namespace tamis {
namespace {

/// The least share of the gap between the features for one that moves.
constexpr double kLeastShare = 1.0 / 64;

/// The first feature's share of the gap: the faster feature gets more.
double first_share(double first_speed, double second_speed) {
  const double speeds = first_speed + second_speed;
  if (!(speeds > 0)) return 0.5;
  const double share = first_speed / speeds;
  return share == 0 || share == 1 ? share : std::clamp(share, kLeastShare, 1 - kLeastShare);
}

/// When does a point that is at `place` at the time `from` reach the level? At once if it is beyond, and still is at
/// t=1.
double time_of_reaching(double level, double place, double speed, double from) {
  if (place + (1 - from) * speed <= level) return 1;
  const double time = from + (level - place) / speed;
  return place <= level && time > from ? std::min(time, 1.0) : from;  // not a number: not beyond
}

/// An upper bound of how far rounding moves a vertex along n.
double rounding_along(const Point& n, const Point& start, const Point& end, Stored stored) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += std::fabs(n[k]) * max_rounding(start[k], end[k], stored);
  return sum;
}

}  // namespace

PairPoints at_rest_at(const PairPoints& points, double time) {
  PairPoints at;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 3; ++k) at.start[i][k] = (1 - time) * points.start[i][k] + time * points.end[i][k];
  at.end = at.start;
  return at;
}

std::array<double, 4> planar_times(const NearPair& there, const PairPoints& points, const PlanarRule& rule,
                                   double time) {
  TAMIS_ASSERT(is_kind(there.kind) && is_finite(points) && 0 <= time && time <= 1);
  const PairPoints at = at_rest_at(points, time);
  const Point n{-there.direction[0], -there.direction[1], -there.direction[2]};  // from the first to the second
  const std::size_t second = second_feature(there.kind), count = vertex_count(there.kind);
  std::array<double, 4> places{}, speeds{}, times{};
  double below = -HUGE_VAL, above = HUGE_VAL, first_speed = 0, second_speed = 0;
  for (std::size_t i = 0; i < count; ++i) {
    places[i] = dot(n, difference(at.start[i], at.start[0]));
    speeds[i] = dot(n, difference(points.end[i], points.start[i]));
    i < second ? below = std::max(below, places[i]) : above = std::min(above, places[i]);
    i < second ? first_speed = std::max(first_speed, speeds[i]) : second_speed = std::max(second_speed, -speeds[i]);
  }
  const double at_start = time > 0 ? start_distance(there.kind, points) : there.distance;
  const double clearance = at_start - rule.separation;
  const double kept = clearance > 0 ? rule.separation + rule.fractions.between_planes(time) * clearance : at_start;
  const double gap = std::max(above - below - kept, 0.0), share = first_share(first_speed, second_speed);
  const double first_level = below + share * gap, second_level = above - (1 - share) * gap;
  for (std::size_t i = 0; i < count; ++i) {
    const double rounding = rounding_along(n, points.start[i], points.end[i], rule.stored);
    times[i] = i < second ? time_of_reaching(first_level - rounding, places[i], speeds[i], time)
                          : time_of_reaching(-second_level - rounding, -places[i], -speeds[i], time);
  }
  return times;
}

}  // namespace tamis

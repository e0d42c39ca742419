#include "detect/planar_times.hpp"

#include <cmath>

#include "motion/pair_kinds.hpp"
#include "narrow/near_pair.hpp"
#include "topology/points.hpp"

namespace tamis {
namespace {

/// The least part of that room for a feature that moves.
constexpr double kLeastPart = 1.0 / 64;

/// The first feature's part of the room between the features: the faster one has more.
double first_part(double first_speed, double second_speed) {
  const double speeds = first_speed + second_speed;
  if (!(speeds > 0)) return 0.5;
  const double part = first_speed / speeds;
  return part == 0 || part == 1 ? part : std::clamp(part, kLeastPart, 1 - kLeastPart);
}

/// When does what is at `place` at the time `from` come to the level? At once if it is beyond, and still is at the end.
double time_at(double level, double place, double speed, double from) {
  if (place + (1 - from) * speed <= level) return 1;
  const double time = from + (level - place) / speed;
  return place <= level && time > from ? std::min(time, 1.0) : from;  // not a number: not beyond
}

/// How far rounding moves a vertex along n at most.
double rounding_along(const Point& n, const Point& start, const Point& end, Stored stored) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += std::fabs(n[k]) * most_rounding(start[k], end[k], stored);
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
  const double room = std::max(above - below - kept, 0.0), part = first_part(first_speed, second_speed);
  const double first_level = below + part * room, second_level = above - (1 - part) * room;
  for (std::size_t i = 0; i < count; ++i) {
    const double rounding = rounding_along(n, points.start[i], points.end[i], rule.stored);
    times[i] = i < second ? time_at(first_level - rounding, places[i], speeds[i], time)
                          : time_at(-second_level - rounding, -places[i], -speeds[i], time);
  }
  return times;
}

}  // namespace tamis

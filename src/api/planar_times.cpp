#include "api/planar_times.hpp"

#include <cmath>

#include "pair/motion/pair_kinds.hpp"
#include "pair/narrow/near_pair.hpp"
#include "search/topology/points.hpp"

namespace tamis {
namespace {

/// A feature that moves gets at least this share of the gap between the features.
constexpr double kLeastShare = 1.0 / 64;

/// How a feature moves along n, towards the other.
struct Approach {
  double speed = 0;     ///< of the vertex that closes in fastest; 0 if none does
  double rounding = 0;  ///< the largest of a vertex' position
  bool needs_room() const { return speed > 0 || rounding > 0; }
};

/// The first feature's share of the gap. The faster feature gets more. A feature that needs no room gets none.
double first_share(const Approach& first, const Approach& second) {
  if (first.needs_room() != second.needs_room()) return first.needs_room() ? 1 : 0;
  const double speeds = first.speed + second.speed;
  return speeds > 0 ? std::clamp(first.speed / speeds, kLeastShare, 1 - kLeastShare) : 0.5;
}

/// The time at which a point that is at `place` at the time `from` reaches the level: 1 if it is not beyond the level
/// at t=1, `from` if it is beyond at both times.
double time_of_reaching(double level, double place, double speed, double from) {
  if (place + (1 - from) * speed <= level) return 1;
  const double time = from + (level - place) / speed;
  return place <= level && time > from ? std::min(time, 1.0) : from;  // `from` also where the time is not a number
}

/// An upper bound of how far rounding moves a vertex along n. A coordinate that does not change is not rounded.
double rounding_along(const Point& n, const Point& start, const Point& end, StoredType stored) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k)
    if (start[k] != end[k]) sum += std::fabs(n[k]) * max_rounding(start[k], end[k], stored);
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
  std::array<double, 4> places{}, speeds{}, roundings{}, times{};
  double below = -HUGE_VAL, above = HUGE_VAL;
  std::array<Approach, 2> approaches;
  for (std::size_t i = 0; i < count; ++i) {
    places[i] = dot(n, difference(at.start[i], at.start[0]));
    speeds[i] = dot(n, difference(points.end[i], points.start[i]));
    roundings[i] = rounding_along(n, points.start[i], points.end[i], rule.stored);
    i < second ? below = std::max(below, places[i]) : above = std::min(above, places[i]);
    Approach& own = approaches[i < second ? 0 : 1];
    own.speed = std::max(own.speed, i < second ? speeds[i] : -speeds[i]);
    own.rounding = std::max(own.rounding, roundings[i]);
  }
  const double at_start = time > 0 ? start_distance(there.kind, points) : there.distance;
  const double clearance = at_start - rule.separation;
  const double kept = clearance > 0 ? rule.separation + rule.fractions.between_planes(time) * clearance : at_start;
  const double gap = std::max(above - below - kept, 0.0), share = first_share(approaches[0], approaches[1]);
  const double first_level = below + share * gap, second_level = above - (1 - share) * gap;
  for (std::size_t i = 0; i < count; ++i)
    times[i] = i < second ? time_of_reaching(first_level - roundings[i], places[i], speeds[i], time)
                          : time_of_reaching(-second_level - roundings[i], -places[i], -speeds[i], time);
  return times;
}

}  // namespace tamis

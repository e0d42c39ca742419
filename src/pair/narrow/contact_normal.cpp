#include "pair/narrow/contact_normal.hpp"

#include <cmath>

#include "numbers/assert.hpp"
#include "numbers/unit_vector.hpp"
#include "pair/distance/rest_distance.hpp"
#include "pair/exact/exact.hpp"
#include "pair/exact/exact_distance.hpp"
#include "pair/narrow/crossing_slope.hpp"

namespace tamis {
namespace {

using Vec = Vec3<double>;

/// A normal along e x f, of any length; zero if e x f is. Computed in integers where rounding would tilt it by more
/// than 2^-28, as for slivers. Components are off by at most 20 u E F, as N in error_bounds.hpp.
Vec normal_at(const PairInStep& pair, double time) {
  const PairMotion<double>& m = pair.motion;
  const Vec normal = cross(at_time(m.e, time), at_time(m.f, time));
  const bool is_sharp = largest_component(normal) > 0x1p-20 * m.size_e * m.size_f + error_bounds::underflow<double>;
  return is_sharp ? normal : exact_normal(pair.kind, pair.points, time);
}

Point unit_point(const Vec& v) {
  const Vec unit = unit_vector(v);
  return {unit.x, unit.y, unit.z};
}

/// A unit vector along e x f. If that vanishes, one orthogonal to e, or if e vanishes, to f.
Point any_normal(const PairInStep& pair, double time) {
  const PairMotion<double>& m = pair.motion;
  const Vec normal = normal_at(pair, time), e = at_time(m.e, time);
  if (largest_component(normal) > 0) return unit_point(normal);
  const Vec w = largest_component(e) > 0 ? e : at_time(m.f, time);
  if (std::fabs(w.x) + std::fabs(w.y) > 0) return unit_point({-w.y, w.x, 0});
  return {1, 0, 0};
}

/// As side_just_before(), by the slope of the coplanarity where it is certain. Before the crossing the coplanarity has
/// the side's sign for a vertex, the opposite one for edges. It goes to zero from there.
int side_before_crossing(const PairInStep& pair, const TimeInterval<double>& time) {
  const double slope = crossing::least_slope_during(pair.motion, time);
  if (slope == 0) return side_just_before(pair.kind, pair.points, time.t_in);
  return (slope > 0) == (pair.kind == PairKind::edge_edge) ? 1 : -1;
}

}  // namespace

ContactPlace closest_place(const PairInStep& pair, double time) {
  TAMIS_ASSERT(0 <= time && time <= 1);
  const auto [u, v, direction, is_sure] =
      with_kind(pair.kind, [&](auto kind) { return direction_apart<kind()>(pair.motion, time); });
  if (!is_sure) return exact_closest_place(pair.kind, pair.points, time);
  return {u, v, {direction.x, direction.y, direction.z}};
}

ContactPlace exact_closest_place(PairKind kind, const PairPoints& points, double time) {
  TAMIS_ASSERT(0 <= time && time <= 1);
  const ExactDistance exact = exact_distance(kind, points, time);
  const Vec direction = with_kind(kind, [&](auto k) { return near_direction<k()>(exact.direction); });
  const bool is_known = largest_component(direction) > 0;
  return {exact.u, exact.v, is_known ? unit_point(direction) : any_normal({kind, points}, time)};
}

ContactPlace crossing_place(const PairInStep& pair, const TimeInterval<double>& time, int side) {
  TAMIS_ASSERT(can_cross(pair.kind) && is_part_of_step(time) && -1 <= side && side <= 1);
  const PairMotion<double>& m = pair.motion;
  const Vec normal = normal_at(pair, time.t_in);  // the side is that at t_in: later the features may turn over
  const double middle = 0.5 * (time.t_in + time.t_out);
  if (side == 0 || !(largest_component(normal) > 0)) return closest_place(pair, time.t_in);
  const auto closest = closest_points(pair.kind, at_time(m.e, middle), at_time(m.f, middle), at_time(m.d, middle));
  return {closest.u, closest.v, unit_point(side > 0 ? normal : -normal)};
}

ContactPlace contact_place(const PairInStep& pair, const TimeInterval<double>& time) {
  if (is_about_distance(pair.kind, pair.motion.separation)) return closest_place(pair, time.t_in);
  return crossing_place(pair, time, side_before_crossing(pair, time));
}

}  // namespace tamis

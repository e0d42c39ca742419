// The axis along which two features lie apart, and how it turns with them. For double and for SIMD lanes.
#pragma once
#include "pair/distance/axis_clip.hpp"
#include "pair/distance/closest.hpp"

namespace tamis {

/// The axis along orthogonal_gap() of the closest points at `t`. It turns such that it stays orthogonal to the same
/// sides.
template <PairKind kind, class T>
inline TurningAxis<T> orthogonal_axis(const PairMotion<T>& m, const T& t, const ClosestPointsOf<T>& closest) {
  const T zero(0), one(1), u = closest.u, v = closest.v;
  const Vec3<T> e = at_time(m.e, t), f = at_time(m.f, t), axis = orthogonal_gap<kind>(e, f, closest);
  const Vec3<T> still{zero, zero, zero};
  const auto along = [&](const Vec3<T>& side, const Vec3<T>& velocity) {
    return -(dot(axis, velocity) * (one / dot(side, side))) * side;
  };
  const Vec3<T> e_velocity = m.e.at1 - m.e.at0;
  const auto inside_e = (u > zero) & (u < one);
  if constexpr (kind == PairKind::vertex_vertex) {
    return {axis, still};
  } else if constexpr (kind == PairKind::vertex_edge) {
    return {axis, select(inside_e, along(e, e_velocity), still)};
  } else {
    // turn = x e + y f such that turn.e = -axis.e' and turn.f = -axis.f'.
    const Vec3<T> f_velocity = m.f.at1 - m.f.at0;
    const T turn_e = -dot(axis, e_velocity), turn_f = -dot(axis, f_velocity);
    const T ee = dot(e, e), ef = dot(e, f), ff = dot(f, f), inverse = one / dot(axis, axis);
    const Vec3<T> within = (inverse * (ff * turn_e - ef * turn_f)) * e + (inverse * (ee * turn_f - ef * turn_e)) * f;
    const auto inside_f = (v > zero) & (v < one);
    if constexpr (kind == PairKind::edge_edge) {
      const Vec3<T> on_side = along(select(inside_e, e, f), select(inside_e, e_velocity, f_velocity));
      return {axis, select(inside_e & inside_f, within, select(inside_e | inside_f, on_side, still))};
    } else {
      const auto off_corner = (u > zero) & (v > zero);
      // The difference of the moving sides, not of their velocities, which would round otherwise.
      const Moving<T> g = m.f - m.e;
      const Vec3<T> side = select(off_corner, at_time(g, t), select(inside_e, e, f));
      const Vec3<T> on_side = along(side, select(off_corner, g.at1 - g.at0, select(inside_e, e_velocity, f_velocity)));
      return {axis,
              select(off_corner & (u + v < one), within, select(off_corner | inside_e | inside_f, on_side, still))};
    }
  }
}

}  // namespace tamis

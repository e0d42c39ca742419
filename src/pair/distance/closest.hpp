// Closest points of two features at one time, in doubles, double-doubles or lanes. They give contact weights,
// distances, and the axis along which the features are apart.
#pragma once
#include "numbers/select.hpp"
#include "numbers/vec.hpp"
#include "pair/motion/pair_kinds.hpp"

namespace tamis {

/// u, v as in Contact. `gap` leads from the closest point of one feature to the closest point of the other. The first
/// is the face, for ee the first edge, for ve the edge, for vv the second vertex.
template <class T>
struct ClosestPointsOf {
  T u, v;
  Vec3<T> gap;
};
using ClosestPoints = ClosestPointsOf<double>;

/// From the point with weights u, v of the face (first edge; edge) to the other feature's. Linear in the vectors.
template <PairKind kind, class T>
inline Vec3<T> gap_at(const Vec3<T>& e, const Vec3<T>& f, const Vec3<T>& d, const T& u, const T& v) {
  return kind == PairKind::edge_edge ? d + v * f - u * e : d - (u * e + v * f);
}

/// Parameter in [0,1] of the point of the segment 0 + s w nearest to p.
template <class T>
inline T nearest_on_segment(const Vec3<T>& p, const Vec3<T>& w) {
  const T length2 = dot(w, w);
  return select(length2 > T(0), min(max(dot(p, w) / length2, T(0)), T(1)), T(0));
}

template <class Mask, class T>
inline void keep_if(const Mask& mask, const ClosestPointsOf<T>& other, ClosestPointsOf<T>& best) {
  best = {select(mask, other.u, best.u), select(mask, other.v, best.v), select(mask, other.gap, best.gap)};
}

template <class T>
inline void keep_nearer(const ClosestPointsOf<T>& other, ClosestPointsOf<T>& best) {
  keep_if(dot(other.gap, other.gap) < dot(best.gap, best.gap), other, best);
}

/// The point d and the triangle 0, e, f: the nearest of the three sides, or the foot of the perpendicular where it lies
/// inside (Ericson 2005, 5.1.5).
template <class T>
inline ClosestPointsOf<T> point_triangle(const Vec3<T>& e, const Vec3<T>& f, const Vec3<T>& d) {
  const auto at = [&](const T& u, const T& v) { return ClosestPointsOf<T>{u, v, d - (u * e + v * f)}; };
  const T zero(0), one(1);
  ClosestPointsOf<T> best = at(nearest_on_segment(d, e), zero);
  keep_nearer(at(zero, nearest_on_segment(d, f)), best);
  const T s = nearest_on_segment(d - e, f - e);
  keep_nearer(at(one - s, s), best);
  const Vec3<T> n = cross(e, f);
  const T norm2 = dot(n, n), u = dot(cross(d, f), n) / norm2, v = dot(cross(e, d), n) / norm2;
  const ClosestPointsOf<T> foot = at(u, v);
  const auto is_inside = (norm2 > zero) & (u >= zero) & (v >= zero) & (u + v <= one);
  keep_if(is_inside & (dot(foot.gap, foot.gap) < dot(best.gap, best.gap)), foot, best);
  return best;
}

/// The segments s e and d + t f: the nearest of the four end points, or the common perpendicular where it meets both.
template <class T>
inline ClosestPointsOf<T> segment_segment(const Vec3<T>& e, const Vec3<T>& f, const Vec3<T>& d) {
  const auto at = [&](const T& s, const T& t) { return ClosestPointsOf<T>{s, t, d + t * f - s * e}; };
  const T zero(0), one(1);
  ClosestPointsOf<T> best = at(zero, nearest_on_segment(-d, f));
  keep_nearer(at(one, nearest_on_segment(e - d, f)), best);
  keep_nearer(at(nearest_on_segment(d, e), zero), best);
  keep_nearer(at(nearest_on_segment(d + f, e), one), best);
  const Vec3<T> n = cross(e, f);
  const T norm2 = dot(n, n), s = dot(cross(d, f), n) / norm2, t = dot(cross(d, e), n) / norm2;
  const ClosestPointsOf<T> feet = at(s, t);
  const auto is_inside = (norm2 > zero) & (s >= zero) & (s <= one) & (t >= zero) & (t <= one);
  keep_if(is_inside & (dot(feet.gap, feet.gap) < dot(best.gap, best.gap)), feet, best);
  return best;
}

/// `e`, `f`, `d` as in PairMotion at one time. Any degenerate feature is legal. Not certified.
template <PairKind kind, class T>
inline ClosestPointsOf<T> closest_points(const Vec3<T>& e, [[maybe_unused]] const Vec3<T>& f, const Vec3<T>& d) {
  if constexpr (kind == PairKind::vertex_face) {
    return point_triangle(e, f, d);
  } else if constexpr (kind == PairKind::edge_edge) {
    return segment_segment(e, f, d);
  } else if constexpr (kind == PairKind::vertex_edge) {
    const T u = nearest_on_segment(d, e);
    return {u, T(0), d - u * e};
  } else if constexpr (kind == PairKind::vertex_vertex) {
    return {T(0), T(0), d};
  }
}

inline ClosestPoints closest_points(PairKind kind, const Vec3<double>& e, const Vec3<double>& f,
                                    const Vec3<double>& d) {
  return with_kind(kind, [&](auto k) { return closest_points<k()>(e, f, d); });
}

/// The gap of the closest points, made orthogonal to the sides that have such a point in their inside. Rounding, a few
/// u of the features' size, would tilt a small gap. Of any length; zero or NaN where it has no direction.
template <PairKind kind, class T>
inline Vec3<T> orthogonal_gap(const Vec3<T>& e, [[maybe_unused]] const Vec3<T>& f, const ClosestPointsOf<T>& closest) {
  const T zero(0), one(1), u = closest.u, v = closest.v;
  const Vec3<T> gap = closest.gap;
  const auto across = [&](const Vec3<T>& side) { return gap - (dot(gap, side) * (one / dot(side, side))) * side; };
  const auto inside_e = (u > zero) & (u < one);
  if constexpr (kind == PairKind::vertex_vertex) {
    return gap;
  } else if constexpr (kind == PairKind::vertex_edge) {
    return select(inside_e, across(e), gap);
  } else {
    const auto inside_f = (v > zero) & (v < one);
    const Vec3<T> n = cross(e, f), normal = select(dot(n, gap) < zero, -n, n);
    if constexpr (kind == PairKind::edge_edge) {
      const Vec3<T> of_side = across(select(inside_e, e, f));
      return select(inside_e & inside_f, normal, select(inside_e | inside_f, of_side, gap));
    } else {
      const auto off_corner = (u > zero) & (v > zero);
      const Vec3<T> of_side = across(select(off_corner, f - e, select(inside_e, e, f)));
      return select(off_corner & (u + v < one), normal, select(off_corner | inside_e | inside_f, of_side, gap));
    }
  }
}

}  // namespace tamis

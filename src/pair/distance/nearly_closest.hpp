// A vector from a point of one feature to a point of the other, nearly the shortest. For proofs that hold with any such
// vector, and succeed with a short one. Without branches, for lanes (after Ericson 2005, 5.1.5 and 5.1.9). Cost: about
// 60 operations for edges, 100 for a vertex and a face.
#pragma once
#include "numbers/error_bounds.hpp"
#include "pair/motion/pair_motion.hpp"

namespace tamis {

struct NearlyClosest {
  /// `e`, `f`, `d` as in PairMotion at one time. The weights lie in [0,1]; any degenerate feature is legal.
  template <PairKind kind, class T>
  static Vec3<T> gap(const Vec3<T>& e, [[maybe_unused]] const Vec3<T>& f, const Vec3<T>& d) {
    if constexpr (kind == PairKind::vertex_face)
      return point_triangle(e, f, d);
    else if constexpr (kind == PairKind::edge_edge)
      return segment_segment(e, f, d);
    else if constexpr (kind == PairKind::vertex_edge)
      return to_segment(d, e);
    else if constexpr (kind == PairKind::vertex_vertex)
      return d;
  }

 private:
  template <class T>
  static T clamped(const T& a) {
    return min(max(a, T(0)), T(1));
  }
  /// A sum of squares, made safe to divide by.
  template <class T>
  static T not_zero(const T& a) {
    return max(a, constant<T>(error_bounds::underflow<T>));
  }

  template <class T>
  static Vec3<T> segment_segment(const Vec3<T>& e, const Vec3<T>& f, const Vec3<T>& d) {
    const T ee = not_zero(dot(e, e)), ff = not_zero(dot(f, f)), ef = dot(e, f), de = dot(d, e), df = dot(d, f);
    const T first = clamped((de * ff - df * ef) / not_zero(ee * ff - ef * ef));
    const T t = clamped((ef * first - df) / ff), s = clamped((ef * t + de) / ee);
    return d + t * f - s * e;
  }

  /// The nearest of the three sides, or the foot of the perpendicular where that lies inside.
  template <class T>
  static Vec3<T> point_triangle(const Vec3<T>& e, const Vec3<T>& f, const Vec3<T>& d) {
    Vec3<T> best = to_segment(d, e);
    keep_shorter(best, to_segment(d, f));
    keep_shorter(best, to_segment(d - e, f - e));
    const T ee = dot(e, e), ff = dot(f, f), ef = dot(e, f), de = dot(d, e), df = dot(d, f);
    const T inverse = T(1) / not_zero(ee * ff - ef * ef);
    const T u = clamped((de * ff - df * ef) * inverse), v = min(clamped((df * ee - de * ef) * inverse), T(1) - u);
    keep_shorter(best, d - (u * e + v * f));
    return best;
  }

  template <class T>
  static Vec3<T> to_segment(const Vec3<T>& p, const Vec3<T>& w) {
    return p - clamped(dot(p, w) / not_zero(dot(w, w))) * w;
  }

  template <class T>
  static void keep_shorter(Vec3<T>& best, const Vec3<T>& other) {
    best = select(dot(other, other) < dot(best, best), other, best);
  }
};

}  // namespace tamis

#include "solve/closest.hpp"

#include <algorithm>

#include "numerics/select.hpp"

namespace tamis {
namespace {

using Vec = Vec3<double>;

/// Parameter in [0,1] of the point of the segment 0 + s w nearest to p.
double nearest_on_segment(const Vec& p, const Vec& w) {
  const double length2 = dot(w, w);
  return length2 > 0 ? std::clamp(dot(p, w) / length2, 0.0, 1.0) : 0;
}

ClosestPoints on_face(const Vec& e, const Vec& f, const Vec& d, double u, double v) {
  return {u, v, d - (u * e + v * f)};
}

void keep_nearer(ClosestPoints& best, const ClosestPoints& other) {
  if (dot(other.gap, other.gap) < dot(best.gap, best.gap)) best = other;
}

/// The nearest of the three sides, or the foot of the perpendicular where it lies inside (Ericson 2005, 5.1.5).
ClosestPoints point_triangle(const Vec& e, const Vec& f, const Vec& d) {
  ClosestPoints best = on_face(e, f, d, nearest_on_segment(d, e), 0);
  keep_nearer(best, on_face(e, f, d, 0, nearest_on_segment(d, f)));
  const double s = nearest_on_segment(d - e, f - e);
  keep_nearer(best, on_face(e, f, d, 1 - s, s));
  const Vec n = cross(e, f);
  const double norm2 = dot(n, n);
  if (!(norm2 > 0)) return best;
  const double u = dot(cross(d, f), n) / norm2, v = dot(cross(e, d), n) / norm2;
  if (u >= 0 && v >= 0 && u + v <= 1) keep_nearer(best, on_face(e, f, d, u, v));
  return best;
}

/// Segments s e and d + t f: the nearest of the four end points, or the common perpendicular where it meets both.
ClosestPoints segment_segment(const Vec& e, const Vec& f, const Vec& d) {
  const auto at = [&](double s, double t) { return ClosestPoints{s, t, d + t * f - s * e}; };
  ClosestPoints best = at(0, nearest_on_segment(-d, f));
  keep_nearer(best, at(1, nearest_on_segment(e - d, f)));
  keep_nearer(best, at(nearest_on_segment(d, e), 0));
  keep_nearer(best, at(nearest_on_segment(d + f, e), 1));
  const Vec n = cross(e, f);
  const double norm2 = dot(n, n);
  if (!(norm2 > 0)) return best;
  const double s = dot(cross(d, f), n) / norm2, t = dot(cross(d, e), n) / norm2;
  if (s >= 0 && s <= 1 && t >= 0 && t <= 1) keep_nearer(best, at(s, t));
  return best;
}

}  // namespace

ClosestPoints closest_points(PairKind kind, const Vec& e, const Vec& f, const Vec& d) {
  switch (kind) {
    case PairKind::vertex_face:
      return point_triangle(e, f, d);
    case PairKind::edge_edge:
      return segment_segment(e, f, d);
    case PairKind::vertex_edge:
      return on_face(e, f, d, nearest_on_segment(d, e), 0);
    case PairKind::vertex_vertex:
      break;
  }
  return {0, 0, d};
}

}  // namespace tamis

#include "solve/weights.hpp"

#include <algorithm>
#include <cmath>

#include "motion/pair_kinds.hpp"
#include "numerics/error_bounds.hpp"
#include "solve/closest.hpp"

namespace tamis {
namespace {

double largest(const Vec3<double>& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

/// Divided by its largest component, so that no square underflows; zero stays zero.
Vec3<double> rescaled(const Vec3<double>& v) {
  const double size = largest(v);
  return size > 0 ? Vec3<double>{v.x / size, v.y / size, v.z / size} : v;
}

/// REQUIRES: not zero.
Point unit_point(const Vec3<double>& a) {
  const Vec3<double> v = rescaled(a);
  const double length = std::sqrt(dot(v, v));
  return {v.x / length, v.y / length, v.z / length};
}

/// A unit vector along e x f, or if that vanishes one orthogonal to what is left.
Point unit_normal(const Vec3<double>& e, const Vec3<double>& f) {
  const Vec3<double> normal = cross(rescaled(e), rescaled(f)), w = largest(e) > 0 ? e : f;
  if (largest(normal) > 0) return unit_point(normal);
  if (std::fabs(w.x) + std::fabs(w.y) > 0) return unit_point({-w.y, w.x, 0});
  return {1, 0, 0};
}

}  // namespace

void add_weights(PairKind kind, const PairMotion<double>& m, double time, PairResult& result) {
  if (!std::isfinite(m.size_e + m.size_f + m.size_d)) {
    result.normal = {1, 0, 0};
    return;
  }
  const auto e = at_time(m.e, time), f = at_time(m.f, time), d = at_time(m.d, time);
  const auto closest = closest_points(kind, e, f, d);
  result.u = closest.u;
  result.v = closest.v;
  const double gap_error = error_bounds::bound(error_bounds::kGap, m.size_d + m.size_e + m.size_f);
  const bool has_gap = largest(closest.gap) > gap_error;
  result.normal = !can_cross(kind) && has_gap ? unit_point(closest.gap) : unit_normal(e, f);
}

}  // namespace tamis

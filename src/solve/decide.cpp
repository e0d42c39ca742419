#include "solve/decide.hpp"

#include <algorithm>
#include <cmath>

#include "solve/closest.hpp"
#include "solve/exact.hpp"
#include "solve/separation.hpp"
#include "solve/start_distance.hpp"
#include "solve/subdivide.hpp"

namespace tamis {
namespace {

bool is_finite(const PairMotion<double>& m) { return std::isfinite(m.size_e + m.size_f + m.size_d); }

/// A face that meets the axes squarely is clipped to the very instant of contact, where no sign is certain any more.
TimeInterval<double> widened(const TimeInterval<double>& time) {
  constexpr double kRoom = 1.0 / 1024;
  return {std::max(time.t_in - kRoom, 0.0), std::min(time.t_out + kRoom, 1.0)};
}

Decision decide_in_doubles(PairKind kind, const PairMotion<double>& m) {
  if (!is_finite(m)) return {Verdict::unsure, 0, 1};
  const TimeInterval<double> step{0, 1};
  const auto time = kind == PairKind::vertex_face ? SlabClip::clip<PairKind::vertex_face>(m, step)
                                                  : SlabClip::clip<PairKind::edge_edge>(m, step);
  if (time.t_in > time.t_out) return {};
  return m.separation > 0 ? first_within(kind, m, time) : subdivide(kind, m, widened(time));
}

/// The start of the step is decided exactly: a pair that is apart there, by whatever little, has a time before it
/// touches; so a line search never stops for nothing.
Decision with_exact_start(PairKind kind, const PairPoints& points, double separation, const Decision& decision) {
  if (decision.verdict == Verdict::is_free || decision.lower > 0 || decision.upper == 0) return decision;
  const double apart = apart_from_start(kind, points, separation);
  if (apart == 0) return {Verdict::touches, 0, 0};
  if (std::isinf(apart)) return {};
  return {decision.verdict, std::min(apart, decision.upper), decision.upper};
}

/// A unit vector along `v`, or if that vanishes one orthogonal to `w`.
Point unit_normal(const Vec3<double>& v, const Vec3<double>& w) {
  const auto normalized = [](const Vec3<double>& a) {
    const double length = std::sqrt(dot(a, a));
    return Point{a.x / length, a.y / length, a.z / length};
  };
  if (dot(v, v) > 0) return normalized(v);
  if (std::fabs(w.x) + std::fabs(w.y) > 0) return normalized({-w.y, w.x, 0});
  return {1, 0, 0};
}

void add_weights(PairKind kind, const PairMotion<double>& m, PairResult& result) {
  if (!is_finite(m)) {
    result.normal = {1, 0, 0};
    return;
  }
  const double t = 0.5 * (result.toi_lower + result.toi_upper);
  const auto e = at_time(m.e, t), f = at_time(m.f, t), d = at_time(m.d, t);
  const auto closest = closest_points(kind, e, f, d);
  result.u = closest.u;
  result.v = closest.v;
  result.normal = unit_normal(cross(e, f), dot(e, e) > 0 ? e : f);
}

}  // namespace

PairResult decide(PairKind kind, const PairPoints& points, const PairOptions& options, PrecisionCount& decided_by) {
  const auto m = make_motion(kind, points, options.min_separation);
  Decision decision = decide_in_doubles(kind, m);
  if (options.min_separation > 0) decision = with_exact_start(kind, points, options.min_separation, decision);
  if (decision.verdict == Verdict::unsure && options.guarantee == Guarantee::exact && options.min_separation == 0) {
    ++decided_by.exact;
    const auto exact = decide_exactly(kind, points);
    decision = {exact.touches ? Verdict::touches : Verdict::is_free, exact.toi_lower, exact.toi_upper};
  } else {
    ++decided_by.scalar;
  }
  if (decision.verdict == Verdict::is_free) return {};
  PairResult result;
  result.touches = true;
  result.certainty = decision.verdict == Verdict::touches ? Certainty::certified : Certainty::unresolved;
  result.toi_lower = decision.lower;
  result.toi_upper = decision.upper;
  add_weights(kind, m, result);
  return result;
}

}  // namespace tamis

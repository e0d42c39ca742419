#include "oracle/turning.hpp"

#include <algorithm>

namespace tamis::oracle {
namespace {

RealPoint minus(const RealPoint& a, const RealPoint& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
RealPoint plus(const RealPoint& a, Real s, const RealPoint& b) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}
Real dot(const RealPoint& a, const RealPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
RealPoint cross(const RealPoint& a, const RealPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Real length(const RealPoint& a) { return std::sqrt(dot(a, a)); }
RealPoint real(const Point& p) { return {p[0], p[1], p[2]}; }

Real to_segment(const RealPoint& p, const RealPoint& a, const RealPoint& b) {
  const RealPoint w = minus(b, a);
  const Real square = dot(w, w), s = square > 0 ? std::clamp(dot(minus(p, a), w) / square, Real(0), Real(1)) : 0;
  return length(minus(p, plus(a, s, w)));
}

Real to_triangle(const RealPoint& p, const RealPoint& a, const RealPoint& b, const RealPoint& c) {
  const Real sides = std::min({to_segment(p, a, b), to_segment(p, b, c), to_segment(p, c, a)});
  const RealPoint n = cross(minus(b, a), minus(c, a));
  const auto is_inside = [&](const RealPoint& x, const RealPoint& y) {
    return dot(n, cross(minus(y, x), minus(p, x))) >= 0;
  };
  if (!(dot(n, n) > 0) || !is_inside(a, b) || !is_inside(b, c) || !is_inside(c, a)) return sides;
  return std::fabs(dot(n, minus(p, a))) / length(n);
}

Real segments(const RealPoint& a0, const RealPoint& a1, const RealPoint& b0, const RealPoint& b1) {
  const Real ends =
      std::min({to_segment(a0, b0, b1), to_segment(a1, b0, b1), to_segment(b0, a0, a1), to_segment(b1, a0, a1)});
  const RealPoint e = minus(a1, a0), f = minus(b1, b0), d = minus(b0, a0), n = cross(e, f);
  const Real square = dot(n, n);
  if (!(square > 0)) return ends;
  const Real s = dot(cross(d, f), n) / square, t = dot(cross(d, e), n) / square;
  if (s < 0 || s > 1 || t < 0 || t > 1) return ends;
  return std::min(ends, std::fabs(dot(n, d)) / std::sqrt(square));
}

/// A bound of the speed of the body's point x.
Real speed(const Turning& body, const Point& x) {
  return length(minus(real(body.theta1), real(body.theta0))) * length(real(x)) +
         length(minus(real(body.p1), real(body.p0)));
}

std::size_t first_of_second(PairKind kind) { return kind == PairKind::vertex_face ? 1 : 2; }

}  // namespace

RealPoint position(const Turning& body, const Point& x, Real t) { return position(body, real(x), t); }

RealPoint position(const Turning& body, const RealPoint& y, Real t) {
  const auto at = [&](const Point& a, const Point& b) { return plus(real(a), t, minus(real(b), real(a))); };
  const RealPoint theta = at(body.theta0, body.theta1), p = at(body.p0, body.p1);
  const Real angle = length(theta);
  if (!(angle > 0)) return plus(y, 1, p);
  // Rodrigues' formula with the half angle: 1 - cos(angle) = 2 sin^2(angle / 2).
  const Real s = std::sin(angle) / angle, h = std::sin(angle / 2) / angle;
  const RealPoint turned = cross(theta, y);
  return plus(plus(plus(y, s, turned), 2 * h * h, cross(theta, turned)), 1, p);
}

Real distance(PairKind kind, const std::array<RealPoint, 4>& x) {
  return kind == PairKind::vertex_face ? to_triangle(x[0], x[1], x[2], x[3]) : segments(x[0], x[1], x[2], x[3]);
}

Real distance(const TurningPair& pair, Real t) {
  std::array<RealPoint, 4> x;
  for (std::size_t i = 0; i < 4; ++i)
    x[i] = position(i < first_of_second(pair.kind) ? pair.first : pair.second, pair.points[i], t);
  return distance(pair.kind, x);
}

Real apart_until(const TurningPair& pair, Real separation) {
  Real fastest_first = 0, fastest_second = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (i < first_of_second(pair.kind))
      fastest_first = std::max(fastest_first, speed(pair.first, pair.points[i]));
    else
      fastest_second = std::max(fastest_second, speed(pair.second, pair.points[i]));
  }
  return apart_until([&](Real t) { return distance(pair, t); }, fastest_first + fastest_second, separation);
}

}  // namespace tamis::oracle

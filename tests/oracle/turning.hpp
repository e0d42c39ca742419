// The oracle of turning bodies: conservative advancement in long double. It uses only the definition of the motion (x
// goes to R(theta(t)) x + p(t)), distances, and a bound on speeds. Slow; shares no code with the library.
#pragma once
#include <array>
#include <cmath>

#include "tamis/contact.hpp"

namespace tamis::oracle {

using Real = long double;
using RealPoint = std::array<Real, 3>;

/// Rotation vector and position at t=0 and t=1, both linear between.
struct Turning {
  Point theta0, theta1, p0, p1;
};

/// Two features in their bodies' frames. vf: the point, then a, b, c. ee: a0, a1, b0, b1.
struct TurningPair {
  PairKind kind;
  std::array<Point, 4> points;
  Turning first, second;
};

RealPoint position(const Turning& body, const RealPoint& x, Real t);
RealPoint position(const Turning& body, const Point& x, Real t);
/// Distance of the closed features.
Real distance(PairKind kind, const std::array<RealPoint, 4>& points);
Real distance(const TurningPair& pair, Real t);

/// The first time at which the pair is nearer than `separation` + 1e-15. Before that time it is proven farther apart,
/// except for rounding (1e-18 of the sizes). Above 1: never.
Real apart_until(const TurningPair& pair, Real separation = 0);

/// The same for any distance(t) that changes by no more than `fastest` a unit of time.
template <class Distance>
Real apart_until(const Distance& distance, Real fastest, Real separation) {
  constexpr Real kFloor = 1e-15L;
  Real t = 0;
  while (t <= 1) {
    const Real apart = distance(t) - separation;
    if (apart < kFloor) return t;
    if (!(fastest > 0)) return 2;
    t += apart / fastest;
  }
  return 2;
}

}  // namespace tamis::oracle

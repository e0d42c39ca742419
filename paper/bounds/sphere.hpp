// Swept sphere: contains the positions at both ends of the step, and thus all between.
#pragma once
#include <cmath>

#include "pair/motion/pair_motion.hpp"

namespace tamis::lab {

/// The radius is computed from the rounded centre, and rounded up.
struct Sphere {
  Vec3<double> centre;
  double radius;

  static Sphere around(const Moving<double>& point, const Vec3<double>& origin, double padding) {
    const Vec3<double> p0 = point.at0 - origin, p1 = point.at1 - origin, centre = 0.5 * (p0 + p1);
    const double reach = max(distance(p0, centre), distance(p1, centre));
    // Subtracting the origin moved the points by up to 2^-52.
    return {centre, rounded_up(reach + padding) + 0x1p-50};
  }

  double extent() const { return radius; }

  static double distance(const Vec3<double>& a, const Vec3<double>& b) {
    const Vec3<double> d = a - b;
    return std::sqrt(dot(d, d));
  }
  /// Covers the few roundings, each below 2^-53 of the result, of a distance and a sum.
  static double rounded_up(double length) { return length * (1 + 0x1p-48) + 0x1p-500; }
};

inline Sphere merge(const Sphere& a, const Sphere& b) {
  const double apart = Sphere::distance(a.centre, b.centre);
  if (apart + b.radius <= a.radius * (1 - 0x1p-48)) return a;
  if (apart + a.radius <= b.radius * (1 - 0x1p-48)) return b;
  const double along = apart > 0 ? 0.5 * (apart + b.radius - a.radius) / apart : 0;
  const Vec3<double> centre = a.centre + along * (b.centre - a.centre);
  return {centre, Sphere::rounded_up(max(Sphere::distance(centre, a.centre) + a.radius,
                                         Sphere::distance(centre, b.centre) + b.radius))};
}

inline bool overlap(const Sphere& a, const Sphere& b) {
  const Vec3<double> d = a.centre - b.centre;
  const double reach = Sphere::rounded_up(a.radius + b.radius);
  return !(dot(d, d) > reach * reach * (1 + 0x1p-48));
}

}  // namespace tamis::lab

#include "paper/bounds/normal_cone.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pair/motion/polynomials.hpp"

namespace tamis::lab {
namespace {

using Vec = Vec3<double>;

constexpr double kPi = std::numbers::pi;
const NormalCone kEverything{{0, 0, 1}, 2 * kPi};

double length(const Vec& v) { return std::sqrt(dot(v, v)); }
double angle(const Vec& a, const Vec& b) { return std::acos(std::clamp(dot(a, b), -1.0, 1.0)); }

}  // namespace

NormalCone NormalCone::around(const Moving<double>& a, const Moving<double>& b, const Moving<double>& c) {
  const Moving<double> e = b - a, f = c - a;
  auto normals = normal_polynomial(e, f);
  // Each coefficient is off by less than 2^-46 times the product of the sizes (error_bounds.hpp has 76 u). So if it is
  // longer than 2^-22 times that product, its direction is off by less than 2^-24, far below the margin.
  const double shortest = 0x1p-22 * largest(e) * largest(f);
  Vec sum{0, 0, 0};
  for (Vec& n : normals) {
    const double size = length(n);
    if (!(size > shortest)) return kEverything;
    n = (1 / size) * n;
    sum = sum + n;
  }
  const double size = length(sum);
  if (!(size > 1)) return kEverything;
  NormalCone cone{(1 / size) * sum, 0};
  // n(t) is a combination of the three with weights >= 0: so a cone with a half-angle below pi/2 that contains the
  // three contains n(t).
  for (const Vec& n : normals) cone.half_angle = std::max(cone.half_angle, angle(cone.axis, n));
  cone.half_angle += kMargin;
  return cone.half_angle < kPi / 2 ? cone : kEverything;
}

NormalCone merge(const NormalCone& a, const NormalCone& b) {
  const double between = angle(a.axis, b.axis);
  if (between + b.half_angle <= a.half_angle) return {a.axis, a.half_angle + NormalCone::kMargin};
  if (between + a.half_angle <= b.half_angle) return {b.axis, b.half_angle + NormalCone::kMargin};
  const double half = 0.5 * (between + a.half_angle + b.half_angle);
  if (!(half < kPi / 2)) return kEverything;
  // Turns a's axis towards b's until the far side of a's cone is at the angle `half` from it.
  const double turn = half - a.half_angle, sine = std::sin(between);
  if (!(sine > 1e-6)) return {a.axis, half + between + NormalCone::kMargin};
  const Vec axis = (std::sin(between - turn) / sine) * a.axis + (std::sin(turn) / sine) * b.axis;
  return {(1 / length(axis)) * axis, half + NormalCone::kMargin};
}

}  // namespace tamis::lab

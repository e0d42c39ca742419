// Interval Newton on the coplanarity cubic, then the inside test at the root: the elementary test of the paper
// (Du, Tang, Tong 2012; the solver is that of Snyder 1992 and Redon, Kheddar, Coquillart 2002).
// Every interval of time is proven free of roots, or proven to hold a root at which the features touch, or given up:
// that is left to solve/decide.hpp.
#pragma once
#include "filters/ncf.hpp"
#include "numerics/interval.hpp"
#include "solve/crossing.hpp"
#include "solve/subdivide.hpp"

namespace tamis {

/// Times of the step. `touches`: apart on [0, lower), touching at some time of [lower, upper], with weights and normal.
struct ElementaryTest {
  Verdict verdict = Verdict::is_free;
  double lower = 1, upper = 1;
  double u = 0, v = 0;
  Vec3<double> normal{0, 0, 0};  ///< not normalized
};

namespace interval_newton {

/// Part of the step below which nothing is cut in two any more.
inline constexpr double kShortest = 0x1p-20;
/// Evaluations for one pair; ordinary pairs need 3 to 12.
inline constexpr int kMaxEvaluations = 96;
inline constexpr std::size_t kMaxDepth = 32;

/// The cubic with its certified enclosures at, and over, times in [0,1].
class Cubic {
 public:
  explicit Cubic(const PairMotion<double>& m)
      : k_(coplanarity_polynomial(m.d, normal_polynomial(m.e, m.f))), unit_(m.size_d * m.size_e * m.size_f) {}

  Interval value(double t) const {
    const double error = error_bounds::bound(error_bounds::kCoplanarityValue, unit_);
    const double value = crossing::value(k_, t);
    return {rounding::below(value - error), rounding::above(value + error)};
  }

  /// Derivative: the hull of its three Bernstein coefficients over [t.lower, t.upper].
  Interval slope(const Interval& t) const {
    const double q0 = k_[1] - 3 * k_[0], q1 = k_[2] - k_[1], q2 = 3 * k_[3] - k_[2];
    const double low = t.lower, high = t.upper, from_low = 1 - low, from_high = 1 - high;
    const double start = from_low * from_low * q0 + 2 * (from_low * low) * q1 + low * low * q2;
    const double mixed = from_low * from_high * q0 + (from_low * high + low * from_high) * q1 + low * high * q2;
    const double end = from_high * from_high * q0 + 2 * (from_high * high) * q1 + high * high * q2;
    const double error = error_bounds::bound(error_bounds::kCoplanaritySlope, unit_);
    return {rounding::below(std::min({start, mixed, end}) - error),
            rounding::above(std::max({start, mixed, end}) + error)};
  }

 private:
  std::array<double, 4> k_;
  double unit_;
};

/// Where the roots of one part of the step are, as far as one descent can tell.
struct Part {
  Interval time;
  bool holds_root = false;   ///< proven: exactly one
  bool has_no_root = false;  ///< proven
};

/// Intervals of time still to be looked at, the earliest on top.
class TimeStack {
 public:
  bool empty() const { return size_ == 0; }
  bool is_full() const { return size_ == kMaxDepth; }
  Interval pop() { return times_[--size_]; }
  void push(const Interval& time) { times_[size_++] = time; }

 private:
  std::array<Interval, kMaxDepth> times_;
  std::size_t size_ = 0;
};

/// Narrows `time` to its first root. Later halves go to `later`.
inline Part descend(const Cubic& cubic, Interval time, TimeStack& later, int& evaluations) {
  Part part{time};
  for (; evaluations < kMaxEvaluations; ++evaluations) {
    const double middle = part.time.middle();
    const Interval value = cubic.value(middle), slope = cubic.slope(part.time);
    if (slope.may_be_zero()) {
      part.holds_root = false;
      const Interval range = value + slope * (part.time - Interval(middle));
      part.has_no_root = !range.may_be_zero();
      if (part.has_no_root || part.time.width() < kShortest || later.is_full()) return part;
      later.push({middle, part.time.upper});
      part.time.upper = middle;
      continue;
    }
    const Interval newton = Interval(middle) - value / slope;
    const Interval next = intersection(part.time, newton);
    part.has_no_root = !(next.lower <= next.upper);
    if (part.has_no_root) return part;
    // Newton's image inside the interval: exactly one root, because the cubic is monotone there.
    part.holds_root |= newton.lower >= part.time.lower && newton.upper <= part.time.upper;
    const bool converged = value.may_be_zero() && next.width() > 0.5 * part.time.width();
    part.time = next;
    if (converged || next.width() < 0x1p-50) return part;
  }
  return part;
}

template <PairKind kind>
inline crossing::Sides<double> inside_test(const PairMotion<double>& m, const Interval& time, Vec3<double>& normal) {
  const double t = time.middle();
  normal = cross(at_time(m.e, t), at_time(m.f, t));
  return crossing::sides<kind>(m, normal, t, 0.5 * time.width() + 0x1p-52);
}

}  // namespace interval_newton

/// REQUIRES: `m` is the motion of the whole step.
template <PairKind kind>
inline ElementaryTest interval_newton_test(const PairMotion<double>& m) {
  namespace newton = interval_newton;
  const newton::Cubic cubic(m);
  newton::TimeStack parts;
  parts.push({0, 1});
  for (int evaluations = 0; !parts.empty();) {
    const newton::Part part = newton::descend(cubic, parts.pop(), parts, evaluations);
    if (part.has_no_root) continue;
    Vec3<double> normal;
    const auto sides = newton::inside_test<kind>(m, part.time, normal);
    if (sides.outside) continue;
    const Interval& time = part.time;
    if (part.holds_root && sides.inside) return {Verdict::touches, time.lower, time.upper, sides.u, sides.v, normal};
    if (Ncf::proves_free<kind>(restrict_to(m, time.lower, time.upper))) continue;
    return {Verdict::unsure, time.lower, 1};
  }
  return {};
}

}  // namespace tamis

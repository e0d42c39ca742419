// Interval Newton on the coplanarity cubic, then the inside test at the root: the elementary test of the paper
// (Du, Tang, Tong 2012; the solver is that of Snyder 1992 and Redon, Kheddar, Coquillart 2002).
// Each interval of time is proven to hold no contact, or to hold a root at which the features touch; a pair with an
// interval that is neither is unsure, and left to pair/narrow/decide.hpp.
#pragma once
#include "numbers/assert.hpp"
#include "numbers/interval.hpp"
#include "pair/filters/ncf.hpp"
#include "pair/motion/decision.hpp"
#include "pair/narrow/crossing.hpp"

namespace tamis::lab {

/// Times of the step. If the verdict is `touches`: apart on [0, lower), touching at some time of [lower, upper], with
/// weights and normal.
template <class T>
struct ElementaryTest {
  Verdict verdict = Verdict::is_free;
  T lower = T(1), upper = T(1);
  T u = T(0), v = T(0);
  Vec3<T> normal{T(0), T(0), T(0)};  ///< as in Contact, but not of unit length
};

namespace interval_newton {

/// Intervals shorter than this part of the step are not cut in two.
inline constexpr double kShortest = 0x1p-20;
/// Evaluations for one pair; ordinary pairs need 3 to 12.
inline constexpr int kMaxEvaluations = 96;
inline constexpr std::size_t kMaxDepth = 32;
/// Error bound of the cubic's value at a time in [0,1], in the form of those in numbers/error_bounds.hpp. Its
/// coefficients' errors, weighted by (1-t)^(3-i) t^i: at most kCoplanarityEnd + kCoplanarityMiddle / 4 = 320 u.
/// Evaluation, with |K0|,|K3| <= 6 and |K1|,|K2| <= 18: below 12 * 10.5 = 126 u.
inline constexpr double kCoplanarityValue = 450;

/// Empty (lower > upper) if the two have no common point.
template <class T>
inline BasicInterval<T> intersection(const BasicInterval<T>& a, const BasicInterval<T>& b) {
  BasicInterval<T> common;
  common.lower = max(a.lower, b.lower);
  common.upper = min(a.upper, b.upper);
  return common;
}

/// The coplanarity cubic, with certified enclosures of its value at a time and of its slope over an interval in [0,1].
template <class T>
class Cubic {
 public:
  explicit Cubic(const PairMotion<T>& m) : k_(coplanarity_polynomial(m)) {
    const T unit = m.size_d * m.size_e * m.size_f;
    value_error_ = error_bounds::bound(kCoplanarityValue, unit);
    slope_error_ = error_bounds::bound(error_bounds::kCoplanaritySlope, unit);
    slope_ = {k_[1] - T(3) * k_[0], k_[2] - k_[1], T(3) * k_[3] - k_[2]};
  }

  BasicInterval<T> value(const T& t) const {
    const T value = crossing::value(k_, t);
    return {rounding::below(value - value_error_), rounding::above(value + value_error_)};
  }

  /// Derivative: the hull of its three Bernstein coefficients over [t.lower, t.upper].
  BasicInterval<T> slope(const BasicInterval<T>& t) const {
    const T low = t.lower, high = t.upper, from_low = T(1) - low, from_high = T(1) - high;
    const auto blossom = [&](const T& a, const T& from_a, const T& b, const T& from_b) {
      return from_a * from_b * slope_[0] + (from_a * b + a * from_b) * slope_[1] + a * b * slope_[2];
    };
    const T start = blossom(low, from_low, low, from_low), mixed = blossom(low, from_low, high, from_high);
    const T end = blossom(high, from_high, high, from_high);
    return {rounding::below(min(start, min(mixed, end)) - slope_error_),
            rounding::above(max(start, max(mixed, end)) + slope_error_)};
  }

 private:
  std::array<T, 4> k_;
  std::array<T, 3> slope_;  ///< Bernstein coefficients of the derivative, the middle one doubled by the blossom
  T value_error_, slope_error_;
};

/// The result of one descent: an interval, and what is proven about the cubic's roots in it.
template <class T>
struct Part {
  BasicInterval<T> time;
  bool holds_root = false;   ///< proven: exactly one
  bool has_no_root = false;  ///< proven
};

/// Intervals of time that are still to be searched, the earliest on top.
template <class T>
class TimeStack {
 public:
  bool empty() const { return size_ == 0; }
  bool is_full() const { return size_ == kMaxDepth; }
  BasicInterval<T> pop() { return times_[--size_]; }
  void push(const BasicInterval<T>& time) { times_[size_++] = time; }

 private:
  std::array<BasicInterval<T>, kMaxDepth> times_;
  std::size_t size_ = 0;
};

/// Narrows `time` to its first root. Later halves go to `later`.
template <class T>
inline Part<T> descend(const Cubic<T>& cubic, const BasicInterval<T>& time, TimeStack<T>& later, int& evaluations) {
  using I = BasicInterval<T>;
  Part<T> part{time};
  for (; evaluations < kMaxEvaluations; ++evaluations) {
    const T middle = part.time.middle();
    const I value = cubic.value(middle), slope = cubic.slope(part.time);
    if (slope.may_be_zero()) {
      part.holds_root = false;
      const I range = value + slope * (part.time - I(middle));
      part.has_no_root = !range.may_be_zero();
      if (part.has_no_root || part.time.width() < T(kShortest) || later.is_full()) return part;
      later.push({middle, part.time.upper});
      part.time.upper = middle;
      continue;
    }
    const I newton = I(middle) - value / slope;
    const I next = intersection(part.time, newton);
    part.has_no_root = !(next.lower <= next.upper);
    if (part.has_no_root) return part;
    // If Newton's image lies inside the interval, that holds exactly one root, because the cubic is monotone there.
    part.holds_root |= newton.lower >= part.time.lower && newton.upper <= part.time.upper;
    const bool converged = value.may_be_zero() && next.width() > T(0.5) * part.time.width();
    part.time = next;
    if (converged || next.width() < T(0x1p-50)) return part;
  }
  return part;
}

template <PairKind kind, class T>
inline crossing::Sides<T> inside_test(const PairMotion<T>& m, const BasicInterval<T>& time, Vec3<T>& normal) {
  const T t = time.middle();
  normal = cross(at_time(m.e, t), at_time(m.f, t));
  return crossing::sides<kind>(m, normal, t, T(0.5) * time.width() + T(0x1p-52));
}

}  // namespace interval_newton

/// REQUIRES: `m` is the motion of the whole step.
template <PairKind kind, class T>
inline ElementaryTest<T> interval_newton_test(const PairMotion<T>& m) {
  TAMIS_ASSERT(is_whole(m));
  namespace newton = interval_newton;
  const newton::Cubic<T> cubic(m);
  newton::TimeStack<T> parts;
  parts.push({T(0), T(1)});
  for (int evaluations = 0; !parts.empty();) {
    const newton::Part<T> part = newton::descend(cubic, parts.pop(), parts, evaluations);
    if (part.has_no_root) continue;
    Vec3<T> normal;
    const auto sides = newton::inside_test<kind>(m, part.time, normal);
    if (sides.outside) continue;
    const BasicInterval<T>& time = part.time;
    if (part.holds_root && sides.inside) {
      // The cubic is monotone here: it rises if a vertex comes from below, and if an edge comes from above.
      const bool is_from_above = (cubic.slope(time).upper < T(0)) == (kind == PairKind::vertex_face);
      return {Verdict::touches, time.lower, time.upper, sides.u, sides.v, is_from_above ? normal : -normal};
    }
    if (Ncf::proves_free<kind>(restrict_to(m, time.lower, time.upper))) continue;
    return {Verdict::unsure, time.lower, T(1)};
  }
  return {};
}

}  // namespace tamis::lab

// Every constant of error_bounds.hpp against exact rational arithmetic: the observed error stays below the bound, over
// whole steps and parts of them. The worst ratio is recorded: near 1 the derivation has a gap, near 0 it is wasteful.
#include "numbers/error_bounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "pair/motion/polynomials.hpp"
#include "pair/narrow/crossing.hpp"
#include "support/exact_motion.hpp"
#include "support/pair_cases.hpp"
#include "support/test_data.hpp"

namespace tamis::test {
namespace {

/// Largest ratio of error to bound seen so far.
struct Worst {
  double ratio = 0;
  void add(double computed, const Rational& truth, double bound) {
    const Rational error = abs(computed - truth);
    if (error == 0) return;
    ratio = std::max(ratio, static_cast<double>(error / bound));
  }
  void check(const char* name) const {
    testing::Test::RecordProperty(name, std::to_string(ratio));
    std::cout << "[ WORST    ] " << name << " " << ratio << " of the bound\n";
    EXPECT_LT(ratio, 1) << name;
    EXPECT_GT(ratio, 1e-3) << name << " is never nearly reached: a bound of the wrong unit?";
  }
};

struct Case {
  PairMotion<double> rounded;
  PairMotion<Rational> exact;
};

/// The library's scale of this motion: a power of two, found from one size.
Rational scale_of(const PairMotion<double>& m, const PairMotion<Rational>& unscaled) {
  const auto pick = [](const auto& v) { return std::array{v.at0.x, v.at0.y, v.at0.z, v.at1.x, v.at1.y, v.at1.z}; };
  const auto scaled = pick(m.e);
  const auto original = pick(unscaled.e);
  for (std::size_t i = 0; i < scaled.size(); ++i)
    if (original[i] != 0) {
      const double ratio = scaled[i] / static_cast<double>(original[i]);
      return Rational(std::ldexp(1.0, static_cast<int>(std::lround(std::log2(std::abs(ratio))))));
    }
  return Rational(1);
}

/// Calls `use` on many motions, whole and restricted, with vectors of very unequal sizes among them.
template <class Use>
void for_each_case(const Use& use, bool are_whole = false) {
  const long cases = repetitions("TAMIS_BOUND_CASES", 1500);
  Random random(41);
  for (long i = 0; i < cases; ++i) {
    const PairKind kind = random.coin() ? PairKind::vertex_face : PairKind::edge_edge;
    auto motion = family_named(random.coin() ? "random" : "near_contact").make(kind, random);
    if (random.coin()) motion = placed(motion, {"", 1, std::ldexp(1.0, random.below(20))});
    Case c{make_motion(kind, to_points(motion)), exact_motion(kind, motion)};
    c.exact = exact_motion(kind, motion, scale_of(c.rounded, c.exact));
    if (!are_whole && random.coin()) {
      const double a = random.unit(), b = random.unit(), from = std::min(a, b), to = std::max(a, b);
      c.rounded = restrict_to(c.rounded, from, to);
      c.exact = restrict_to(c.exact, Rational(from), Rational(to));
    }
    use(c);
  }
}

TEST(ErrorBounds, InputVectorsAndTheirSums) {
  Worst input;
  for_each_case([&](const Case& c) {
    const auto add = [&](const Moving<double>& v, const Moving<Rational>& truth, double size) {
      const double bound = error_bounds::bound(error_bounds::kInput, size);
      input.add(v.at0.x, truth.at0.x, bound);
      input.add(v.at1.z, truth.at1.z, bound);
    };
    add(c.rounded.d, c.exact.d, c.rounded.size_d);
    add(c.rounded.e, c.exact.e, c.rounded.size_e);
    add(c.rounded.f - c.rounded.e, c.exact.f - c.exact.e, c.rounded.size_e + c.rounded.size_f);
  });
  input.check("kInput");
}

TEST(ErrorBounds, CoplanarityPolynomial) {
  Worst end, middle;
  for_each_case([&](const Case& c) {
    const PairMotion<double>& m = c.rounded;
    const auto k = coplanarity_polynomial(m);
    const auto truth = coplanarity_polynomial(c.exact.d, normal_polynomial(c.exact.e, c.exact.f));
    const double unit = m.size_d * m.size_e * m.size_f;
    for (std::size_t i : {0u, 3u}) end.add(k[i], truth[i], error_bounds::bound(error_bounds::kCoplanarityEnd, unit));
    for (std::size_t i : {1u, 2u})
      middle.add(k[i], truth[i], error_bounds::bound(error_bounds::kCoplanarityMiddle, unit));
  });
  end.check("kCoplanarityEnd");
  middle.check("kCoplanarityMiddle");
}

// Of a part of the step, from the cubic of the whole: not worse than from the motion during that part.
TEST(ErrorBounds, CoplanarityPolynomialRestricted) {
  Worst end, middle;
  Random random(59);
  for_each_case(
      [&](const Case& c) {
        const double a = random.unit(), b = random.unit(), from = std::min(a, b),
                     to = random.coin() ? std::max(a, b) : 1;
        const auto k = restrict_to(coplanarity_polynomial(c.rounded), from, to);
        const auto truth = coplanarity_polynomial(restrict_to(c.exact, Rational(from), Rational(to)));
        const double unit = c.rounded.size_d * c.rounded.size_e * c.rounded.size_f;
        for (std::size_t i : {0u, 3u})
          end.add(k[i], truth[i], error_bounds::bound(error_bounds::kCoplanarityEnd, unit));
        for (std::size_t i : {1u, 2u})
          middle.add(k[i], truth[i], error_bounds::bound(error_bounds::kCoplanarityMiddle, unit));
      },
      true);
  end.check("kCoplanarityEnd of a part");
  middle.check("kCoplanarityMiddle of a part");
}

template <class T>
T coplanarity_at(const PairMotion<T>& m, const T& t) {
  return dot(at_time(m.d, t), cross(at_time(m.e, t), at_time(m.f, t)));
}

TEST(ErrorBounds, CoplanarityAtOneTime) {
  Worst now;
  Random random(43);
  for_each_case(
      [&](const Case& c) {
        const double t = random.unit();
        const PairMotion<double>& m = c.rounded;
        now.add(coplanarity_at(m, t), coplanarity_at(c.exact, Rational(t)),
                error_bounds::bound(error_bounds::kCoplanarityNow, m.size_d * m.size_e * m.size_f));
      },
      true);
  now.check("kCoplanarityNow");
}

// What one crossing relies on: the slope of the restricted cubic, and that within r it changes K by no more.
TEST(ErrorBounds, CoplanaritySlopeAndBend) {
  Worst slope;
  double bend = 0;
  Random random(47);
  for_each_case([&](const Case& c) {
    const auto k = coplanarity_polynomial(c.rounded.d, normal_polynomial(c.rounded.e, c.rounded.f));
    const auto truth = coplanarity_polynomial(c.exact.d, normal_polynomial(c.exact.e, c.exact.f));
    const double unit = c.rounded.size_d * c.rounded.size_e * c.rounded.size_f, t = random.unit(), r = random.unit();
    const Rational exact_slope = crossing::slope(truth, Rational(t));
    slope.add(crossing::slope(k, t), exact_slope, error_bounds::bound(error_bounds::kCoplanaritySlope, unit));
    const Rational there = Rational(t) + Rational(r * (1 - t));
    const Rational distance = there - Rational(t);
    const Rational rest = crossing::value(truth, there) - crossing::value(truth, Rational(t)) - distance * exact_slope;
    if (distance > 0) bend = std::max(bend, static_cast<double>(abs(rest) / (distance * distance * unit)));
  });
  slope.check("kCoplanaritySlope");
  RecordProperty("bend", std::to_string(bend));
  EXPECT_LE(bend, error_bounds::kBend);
  EXPECT_GE(bend, 1e-3 * error_bounds::kBend);
}

TEST(ErrorBounds, SidePolynomial) {
  Worst end, next, middle;
  for_each_case([&](const Case& c) {
    const auto sides = [](const auto& m) {
      return side_polynomial(m.d - m.e, edge_plane_polynomial(m.f - m.e, normal_polynomial(m.e, m.f)));
    };
    const auto s = sides(c.rounded);
    const auto truth = sides(c.exact);
    const auto& m = c.rounded;
    const double unit = (m.size_d + m.size_e) * (m.size_e + m.size_f) * m.size_e * m.size_f;
    for (std::size_t i : {0u, 4u}) end.add(s[i], truth[i], error_bounds::bound(error_bounds::kSideEnd, unit));
    for (std::size_t i : {1u, 3u}) next.add(s[i], truth[i], error_bounds::bound(error_bounds::kSideNext, unit));
    middle.add(s[2], truth[2], error_bounds::bound(error_bounds::kSideMiddle, unit));
  });
  end.check("kSideEnd");
  next.check("kSideNext");
  middle.check("kSideMiddle");
}

template <class T>
T side_at(const PairMotion<T>& m, const T& t) {
  const auto e = at_time(m.e, t), f = at_time(m.f, t), d = at_time(m.d, t);
  const auto n = cross(e, f);
  return dot(d - e, cross(f, n) - cross(e, n));
}

// What one crossing relies on where it says inside or outside: the side's value, and how little it changes near by.
TEST(ErrorBounds, SideAtOneTimeAndNearIt) {
  Worst now;
  double slope = 0;
  Random random(53);
  for_each_case(
      [&](const Case& c) {
        const auto& m = c.rounded;
        const double t = random.unit(), there = random.unit();
        const double unit = (m.size_d + m.size_e) * (m.size_e + m.size_f) * m.size_e * m.size_f;
        const Rational truth = side_at(c.exact, Rational(t));
        now.add(side_at(m, t), truth, error_bounds::bound(error_bounds::kSideValue, unit));
        const Rational change = side_at(c.exact, Rational(there)) - truth;
        if (there != t) slope = std::max(slope, std::abs(static_cast<double>(change)) / (std::abs(there - t) * unit));
      },
      true);
  now.check("kSideValue");
  RecordProperty("slope", std::to_string(slope));
  EXPECT_LE(slope, error_bounds::kSideSlope);
  EXPECT_GE(slope, 1e-3 * error_bounds::kSideSlope);
}

TEST(ErrorBounds, ProjectionOnADiagonal) {
  Worst projection;
  for_each_case([&](const Case& c) {
    const auto far_corner = [](const auto& m) {
      return m.d.at1.x - m.d.at1.y + m.d.at1.z - (m.e.at1.x - m.e.at1.y + m.e.at1.z);
    };
    const double unit = c.rounded.size_d + c.rounded.size_e + c.rounded.size_f;
    projection.add(far_corner(c.rounded), far_corner(c.exact), error_bounds::bound(error_bounds::kProjection, unit));
  });
  projection.check("kProjection");
}

}  // namespace
}  // namespace tamis::test

// The polynomials in exact arithmetic: equal to what they claim to be at every time.
#include "pair/motion/polynomials.hpp"

#include <gtest/gtest.h>

#include "support/exact_motion.hpp"
#include "support/pair_cases.hpp"

namespace tamis::test {
namespace {

/// Value at t of a polynomial given by Bernstein coefficients without their binomials.
template <class Value, std::size_t n>
Value bernstein(const std::array<Value, n>& c, const Rational& t) {
  const Rational s = Rational(1) - t;
  Value sum = Rational(0) * c[0];
  for (std::size_t i = 0; i < n; ++i) {
    Rational weight(1);
    for (std::size_t k = 0; k < i; ++k) weight = weight * t;
    for (std::size_t k = i + 1; k < n; ++k) weight = weight * s;
    sum = sum + weight * c[i];
  }
  return sum;
}

void expect_equal(const Vec3<Rational>& a, const Vec3<Rational>& b) {
  EXPECT_TRUE(a.x == b.x && a.y == b.y && a.z == b.z);
}

TEST(Polynomials, AreTheirDefinitionsAtEveryTime) {
  Random random(3);
  for (const Family& family : kFamilies)
    for (const PairKind kind : {PairKind::vertex_face, PairKind::edge_edge})
      for (int i = 0; i < 20; ++i) {
        const auto m = exact_motion(kind, family.make(kind, random));
        const auto n = normal_polynomial(m.e, m.f);
        const auto k = coplanarity_polynomial(m.d, n);
        const auto plane = edge_plane_polynomial(m.e, n);
        const auto side = side_polynomial(m.d, plane);
        for (const double time : {0.0, 0.25, 0.7, 1.0}) {
          const Rational t(time);
          const auto e = at_time(m.e, t), f = at_time(m.f, t), d = at_time(m.d, t);
          expect_equal(bernstein(n, t), cross(e, f));
          EXPECT_TRUE(bernstein(k, t) == dot(d, cross(e, f)));
          expect_equal(bernstein(plane, t), cross(e, cross(e, f)));
          EXPECT_TRUE(bernstein(side, t) == dot(d, cross(e, cross(e, f))));
        }
      }
}

// Small integers: doubles do not round, so both arithmetics must agree. Catches a term of one template that only
// the number type double would take.
TEST(Polynomials, InDoublesEqualTheExactOnesWhereNothingRounds) {
  Random random(4);
  const Family& lattice = family_named("lattice");
  for (int i = 0; i < 200; ++i) {
    const auto motion = lattice.make(PairKind::vertex_face, random);
    const auto m = make_motion(PairKind::vertex_face, to_points(motion));
    const auto n = normal_polynomial(m.e, m.f);
    const auto k = coplanarity_polynomial(m.d, n);
    const auto exact = exact_motion(PairKind::vertex_face, motion);
    const auto exact_k = coplanarity_polynomial(exact.d, normal_polynomial(exact.e, exact.f));
    for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(k[c] == 0, exact_k[c] == 0);
  }
}

TEST(Polynomials, RestrictedMotionEndsWhereTheWholeOneIs) {
  Random random(5);
  const auto m = exact_motion(PairKind::edge_edge, family_named("random").make(PairKind::edge_edge, random));
  const auto part = restrict_to(m, Rational(0.3), Rational(0.8));
  expect_equal(part.d.at0, at_time(m.d, Rational(0.3)));
  expect_equal(part.d.at1, at_time(m.d, Rational(0.8)));
  expect_equal(at_time(part.e, Rational(0.5)),
               at_time(m.e, Rational(0.3) + Rational(0.5) * (Rational(0.8) - Rational(0.3))));
}

}  // namespace
}  // namespace tamis::test

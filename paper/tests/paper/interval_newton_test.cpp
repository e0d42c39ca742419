// Whatever interval Newton settles, the exact decision must settle the same way, and within its bracket.
#include "paper/pipeline/interval_newton.hpp"

#include <gtest/gtest.h>

#include <random>

#include "pair/exact/exact.hpp"

namespace tamis::lab {
namespace {

/// Coordinates on a grid of 1/4 make coplanar, degenerate and exactly touching pairs common; a random one none.
PairPoints random_points(std::mt19937_64& random, bool on_grid) {
  std::uniform_real_distribution<double> unit(-1, 1);
  std::uniform_int_distribution<int> grid(-4, 4);
  PairPoints points;
  for (auto* at : {&points.start, &points.end})
    for (Point& p : *at)
      for (double& c : p) c = on_grid ? 0.25 * grid(random) : unit(random);
  return points;
}

struct Tally {
  int is_free = 0, touches = 0, unsure = 0;
};

template <PairKind kind>
void expect_exact(const PairPoints& points, Tally& tally) {
  const auto test = interval_newton_test<kind>(make_motion(kind, points));
  if (test.verdict == Verdict::unsure) {
    ++tally.unsure;
    return;
  }
  const Decision exact = decide_exactly(kind, points);
  ++(exact.touches() ? tally.touches : tally.is_free);
  ASSERT_EQ(test.verdict == Verdict::touches, exact.touches());
  if (!exact.touches()) return;
  EXPECT_LE(test.lower, exact.upper);
  EXPECT_GE(test.upper, exact.lower);
  EXPECT_GE(std::min(test.u, test.v), 0);
  EXPECT_LE(std::max(test.u, test.v), 1);
}

template <PairKind kind>
Tally compare(bool on_grid, int pairs) {
  std::mt19937_64 random(7);
  Tally tally;
  for (int i = 0; i < pairs; ++i) expect_exact<kind>(random_points(random, on_grid), tally);
  return tally;
}

TEST(interval_newton, settles_every_ordinary_pair_as_the_exact_decision_does) {
  for (const Tally& tally : {compare<PairKind::vertex_face>(false, 4000), compare<PairKind::edge_edge>(false, 4000)}) {
    EXPECT_GT(tally.is_free, 1000);
    EXPECT_GT(tally.touches, 100);
    EXPECT_LE(tally.unsure, 4);
  }
}

TEST(interval_newton, never_contradicts_the_exact_decision_on_degenerate_pairs) {
  for (const Tally& tally : {compare<PairKind::vertex_face>(true, 4000), compare<PairKind::edge_edge>(true, 4000)}) {
    EXPECT_GT(tally.is_free, 500);
    EXPECT_GT(tally.touches, 100);
  }
}

TEST(interval_newton, gives_up_where_the_points_are_always_coplanar) {
  // A public code took a vanishing cubic for "no collision": every contact within a plane was missed.
  const PairPoints flat{{{{-1, 0.1, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                        {{{1, 0.1, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}};
  const auto test = interval_newton_test<PairKind::vertex_face>(make_motion(PairKind::vertex_face, flat));
  EXPECT_EQ(test.verdict, Verdict::unsure);
}

TEST(interval_newton, brackets_an_ordinary_contact_to_a_few_roundings) {
  const PairPoints falling{{{{0.25, 0.25, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                           {{{0.25, 0.25, -2}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}};
  const auto test = interval_newton_test<PairKind::vertex_face>(make_motion(PairKind::vertex_face, falling));
  ASSERT_EQ(test.verdict, Verdict::touches);
  EXPECT_LE(test.lower, 1.0 / 3);
  EXPECT_GE(test.upper, 1.0 / 3);
  EXPECT_LE(test.upper - test.lower, 1e-12);
  EXPECT_NEAR(test.u, 0.25, 1e-12);
  EXPECT_NEAR(test.v, 0.25, 1e-12);
}

TEST(interval, division_has_the_right_ends_for_all_signs) {
  for (const Interval& a : {Interval(-3, -2), Interval(-2, 5), Interval(4, 6), Interval(0, 1), Interval(-1, 0)})
    for (const Interval& b : {Interval(0.5, 3), Interval(-3, -0.5)}) {
      const Interval quotient = a / b;
      const auto ends = {a.lower / b.lower, a.lower / b.upper, a.upper / b.lower, a.upper / b.upper};
      EXPECT_LE(quotient.lower, std::min(ends));
      EXPECT_GE(quotient.upper, std::max(ends));
      EXPECT_NEAR(quotient.lower, std::min(ends), 1e-14);
      EXPECT_NEAR(quotient.upper, std::max(ends), 1e-14);
    }
}

TEST(interval, products_and_quotients_contain_the_exact_ones) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 20000; ++i) {
    const double a = unit(random), b = unit(random);
    const long double wide_a = a, wide_b = b;
    const auto contains = [](const Interval& x, long double y) {
      return static_cast<long double>(x.lower) <= y && y <= static_cast<long double>(x.upper);
    };
    ASSERT_TRUE(contains(Interval(a) * Interval(b), wide_a * wide_b));
    ASSERT_TRUE(contains(Interval(a) + Interval(b), wide_a + wide_b));
    ASSERT_TRUE(contains(Interval(a) / Interval(b), wide_a / wide_b));
  }
}

TEST(interval, polynomials_of_a_motion_confirm_the_error_bounds_of_the_filters) {
  // The same templates on intervals enclose the true coefficients; on doubles they are off by less than the bound.
  std::mt19937_64 random(5);
  for (int i = 0; i < 2000; ++i) {
    const auto m = make_motion(PairKind::vertex_face, random_points(random, false));
    const auto widen = [](const Moving<double>& v) {
      return Moving<Interval>{{v.at0.x, v.at0.y, v.at0.z}, {v.at1.x, v.at1.y, v.at1.z}};
    };
    const auto k = coplanarity_polynomial(m);
    const auto wide = coplanarity_polynomial(widen(m.d), normal_polynomial(widen(m.e), widen(m.f)));
    const double unit = m.size_d * m.size_e * m.size_f;
    for (std::size_t c = 0; c < 4; ++c) {
      const double factor = c == 0 || c == 3 ? error_bounds::kCoplanarityEnd : error_bounds::kCoplanarityMiddle;
      const double bound = error_bounds::bound(factor, unit);
      EXPECT_LE(k[c] - bound, wide[c].lower);
      EXPECT_GE(k[c] + bound, wide[c].upper);
    }
  }
}

}  // namespace
}  // namespace tamis::lab

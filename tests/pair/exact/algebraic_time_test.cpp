// Roots told apart, and signs at them, where bisection has a hard time: neighbours, halving points, common factors.
#include "pair/exact/algebraic_time.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "pair/exact/root_isolation.hpp"

namespace tamis {
namespace {

/// Product of (a_i t - b_i), from its Bernstein coefficients without binomials: a_i t - b_i has (-b_i, a_i - b_i).
IntegerPolynomial with_roots(const std::array<std::pair<Integer, Integer>, 3>& ratios) {
  std::array<Integer, 4> product{Integer(1), {}, {}, {}};
  for (const auto& [b, a] : ratios)
    for (std::size_t i = 4; i-- > 0;) product[i] = product[i] * -b + (i > 0 ? product[i - 1] * (a - b) : Integer(0));
  return IntegerPolynomial::from_bernstein(product);
}

IntegerPolynomial linear(const Integer& b, const Integer& a) {
  return IntegerPolynomial::from_bernstein<2>({-b, a - b});
}

using Brackets = std::vector<std::pair<double, double>>;

/// Those until `latest` at least, and no others.
void expect_brackets_until(double latest, const IntegerPolynomial& p, const Brackets& expected) {
  auto roots = roots_in_unit_interval(p, latest);
  ASSERT_LE(roots.size(), expected.size());
  for (std::size_t i = 0; i < roots.size(); ++i) {
    EXPECT_EQ(roots[i].bracket().t_in, expected[i].first) << "until " << latest;
    EXPECT_EQ(roots[i].bracket().t_out, expected[i].second) << "until " << latest;
  }
  if (roots.size() < expected.size()) {
    EXPECT_GT(expected[roots.size()].second, latest);
  }
}

void expect_brackets(const IntegerPolynomial& p, const Brackets& expected) {
  EXPECT_EQ(roots_in_unit_interval(p).size(), expected.size());
  for (const double latest : {0.0, 0x1p-1074, 0.3, 0.5, 0.6, 1.0}) expect_brackets_until(latest, p, expected);
  for (const auto& [lower, upper] : expected)
    for (const double latest : {lower, upper}) expect_brackets_until(latest, p, expected);
}

// Catches an end or a halving point that is reported twice, or by neither of its halves.
TEST(Roots, at_ends_and_halving_points_come_once_and_in_order) {
  expect_brackets(with_roots({{{0, 1}, {1, 2}, {1, 1}}}), {{0, 0}, {0.5, 0.5}, {1, 1}});
  expect_brackets(with_roots({{{1, 4}, {1, 2}, {3, 4}}}), {{0.25, 0.25}, {0.5, 0.5}, {0.75, 0.75}});
  expect_brackets(with_roots({{{1, 2}, {1, 2}, {0, 1}}}), {{0, 0}, {0.5, 0.5}});
  expect_brackets(with_roots({{{1, 1}, {1, 1}, {1, 1}}}), {{1, 1}});
  expect_brackets(with_roots({{{-1, 1}, {2, 1}, {3, 1}}}), {});
}

// Catches a bracket that a second root shares, and a loop that stops at double precision.
TEST(Roots, closer_than_doubles_are_told_apart) {
  const Integer unit = Integer(1) << 200;
  const double half = 0.5, next = std::nextafter(0.5, 1.0), before = std::nextafter(0.5, 0.0);
  expect_brackets(with_roots({{{unit - 1, unit << 1}, {unit + 1, unit << 1}, {5, 1}}}), {{before, half}, {half, next}});
  expect_brackets(with_roots({{{unit + 1, unit << 1}, {unit + 2, unit << 1}, {unit + 4, unit << 1}}}),
                  {{half, next}, {half, next}, {half, next}});
}

// Catches brackets that mistake a subnormal's spacing.
TEST(Roots, among_the_smallest_doubles) {
  const double smallest = std::numeric_limits<double>::denorm_min();
  const Integer huge = Integer(1) << 1074;
  expect_brackets(with_roots({{{1, huge}, {3, huge << 1}, {1, huge << 1}}}),
                  {{0, smallest}, {smallest, smallest}, {smallest, 2 * smallest}});
}

// Catches a common factor that is not seen, or is taken for a root of this cell when it is one of another cell.
TEST(Signs, at_a_root_are_zero_only_for_a_common_root) {
  const auto p = with_roots({{{1, 3}, {2, 3}, {5, 7}}});
  auto roots = roots_in_unit_interval(p);
  ASSERT_EQ(roots.size(), 3u);
  for (int i = 0; i < 2; ++i) {  // twice: the first question may change how the root is kept
    EXPECT_EQ(roots[0].sign_of(linear(1, 3)), 0);
    EXPECT_EQ(roots[1].sign_of(linear(1, 3)), 1);
    EXPECT_EQ(roots[1].sign_of(linear(2, 3)), 0);
    EXPECT_EQ(roots[2].sign_of(linear(2, 3)), 1);
    EXPECT_EQ(roots[0].sign_of(p), 0);
    EXPECT_EQ(roots[0].sign_of(linear(5, 7)), -1);
    EXPECT_EQ(roots[0].sign_of({}), 0);
  }
}

// Catches a sign that is taken before the root and the other polynomial's root are apart.
TEST(Signs, beside_a_root_are_right_at_any_distance) {
  auto roots = roots_in_unit_interval(with_roots({{{1, 3}, {5, 1}, {7, 1}}}));
  for (int bits = 1; bits < 600; bits += 37) {
    const Integer unit = Integer(3) << bits;
    EXPECT_EQ(roots.at(0).sign_of(linear((Integer(1) << bits) - 1, unit)), 1);
    EXPECT_EQ(roots.at(0).sign_of(linear((Integer(1) << bits) + 1, unit)), -1);
  }
}

// Bug: a time carries the 1074 bits of its double's neighbourhood, and all that is computed at it; or loses some.
TEST(DyadicCell, is_shortest_at_a_time) {
  for (const double time : {0.0, 1.0, 0.5, 0.75, 0.1, 0x1p-1074, 0x1.8p-1000, 1 - 0x1p-53}) {
    const DyadicCell cell = shortest_cell_at(time);
    EXPECT_EQ(lower_end(cell), time);
    EXPECT_TRUE(lower_end_is_double(cell));
    EXPECT_TRUE(cell.k == 0 || cell.n.trailing_zeros() == 0) << time;
  }
}

// Catches an order by doubles, a common root of two polynomials that is two times, and a time between that is not.
TEST(AlgebraicTimes, of_several_polynomials_have_an_order) {
  const Integer unit = Integer(1) << 200;
  // Once each, but 1/3 and the root of 2 over 2, which are those of two polynomials; some closer than doubles.
  const IntegerPolynomial two_t2_minus_one = IntegerPolynomial::from_bernstein<3>({-1, -1, 1});
  const IntegerPolynomial polynomials[] = {with_roots({{{0, 1}, {1, 3}, {1, 1}}}),
                                           with_roots({{{unit - 1, unit << 1}, {1, 2}, {unit + 1, unit << 1}}}),
                                           two_t2_minus_one * linear(1, 3), two_t2_minus_one * linear(4, 5)};
  std::vector<AlgebraicTime> times;
  for (const IntegerPolynomial& p : polynomials)
    for (AlgebraicTime& time : roots_in_unit_interval(p)) times.push_back(std::move(time));
  ASSERT_EQ(times.size(), 10);
  const std::vector<int> places{0, 1, 7, 2, 3, 4, 1, 5, 5, 6};
  for (std::size_t i = 0; i < times.size(); ++i)
    for (std::size_t j = 0; j < times.size(); ++j) {
      if (i == j) continue;
      const int order = places[i] - places[j];
      EXPECT_EQ(compare(times[i], times[j]), order < 0 ? -1 : order > 0 ? 1 : 0) << i << " " << j;
      if (order >= 0) continue;
      AlgebraicTime between = AlgebraicTime::exactly(time_between(times[i], times[j]));
      EXPECT_EQ(compare(times[i], between), -1);
      EXPECT_EQ(compare(between, times[j]), -1);
    }
}

}  // namespace
}  // namespace tamis

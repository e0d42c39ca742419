// Roots and signs by odds, in doubles, against integers alone: on polynomials whose coefficients have exponents of
// their own. TAMIS_EXACT_CASES sets the number of cases.
#include "exact/odds_polynomial.hpp"

#include <gtest/gtest.h>
#include <pthread.h>

#include <cmath>
#include <limits>

#include "exact/root_isolation.hpp"
#include "scenes/random.hpp"
#include "support/test_data.hpp"

namespace tamis::test {
namespace {

using scenes::Random;

/// Some are zero, some powers of two: roots at the ends, and terms that are equally large.
Integer random_coefficient(Random& random, Index spread) {
  const Index kind = random.below(8);
  const std::int64_t size = kind == 0 ? 0 : kind == 1 ? 1 : std::int64_t{1} + random.below(1 << 30);
  return Integer(random.coin() ? size : -size) << static_cast<unsigned long>(random.below(spread));
}

template <std::size_t N>
IntegerPolynomial random_polynomial(Random& random, Index spread) {
  std::array<Integer, N> bernstein;
  for (Integer& b : bernstein) b = random_coefficient(random, spread);
  return IntegerPolynomial::from_bernstein(bernstein);
}

IntegerPolynomial random_polynomial(Random& random) {
  constexpr std::array<Index, 5> kSpreads{2, 40, 300, 2000, 6000};
  const Index spread = kSpreads[static_cast<std::size_t>(random.below(Index{kSpreads.size()}))];
  switch (random.below(3)) {
    case 0:
      return random_polynomial<3>(random, spread);
    case 1:
      return random_polynomial<4>(random, spread);
    default:
      return random_polynomial<7>(random, spread);
  }
}

/// Another polynomial, one with roots very near those of `p`, or one with the same.
IntegerPolynomial random_companion(const IntegerPolynomial& p, Random& random) {
  const IntegerPolynomial other = random_polynomial<3>(random, 2000);
  switch (random.below(3)) {
    case 0:
      return other;
    case 1:
      return (Integer(1) << static_cast<unsigned long>(random.below(4000))) * p + other;
    default:
      return p.degree() <= 4 ? p * other : p;
  }
}

void expect_same_roots(const IntegerPolynomial& p, Random& random) {
  auto roots = roots_in_unit_interval(p), expected = roots_by_bisection(p);
  ASSERT_EQ(roots.size(), expected.size());
  for (std::size_t i = 0; i < roots.size(); ++i) {
    EXPECT_EQ(roots[i].bracket().lower, expected[i].bracket().lower);
    EXPECT_EQ(roots[i].bracket().upper, expected[i].bracket().upper);
    for (int turn = 0; turn < 3; ++turn) {
      const IntegerPolynomial q = random_companion(p, random);
      EXPECT_EQ(roots[i].sign_of(q), expected[i].sign_of(q));
    }
    EXPECT_EQ(roots[i].bracket().lower, expected[i].bracket().lower);  // a sign narrows what is known of the time
    EXPECT_EQ(roots[i].bracket().upper, expected[i].bracket().upper);
  }
}

// Catches a root that doubles lose, find twice or put beside its place, and a wrong sign at one.
TEST(Odds, find_the_roots_and_signs_that_integers_find) {
  Random random(5);
  for (long i = 10 * repetitions("TAMIS_EXACT_CASES", 200); i > 0 && !testing::Test::HasFailure(); --i)
    if (const IntegerPolynomial p = random_polynomial(random); !p.is_zero()) expect_same_roots(p, random);
}

// Catches cells halved by calls within calls, as many as exponents have bits: threads have small stacks.
TEST(Odds, and_integers_need_little_stack) {
  const auto find_roots = [](void*) -> void* {
    Random random(5);
    for (int i = 0; i < 500; ++i)
      if (const IntegerPolynomial p = random_polynomial(random); !p.is_zero()) {
        roots_by_bisection(p);
        roots_in_unit_interval(p);
      }
    return nullptr;
  };
  pthread_attr_t attributes;
  ASSERT_EQ(pthread_attr_init(&attributes), 0);
  ASSERT_EQ(pthread_attr_setstacksize(&attributes, std::size_t{1} << 18), 0);
  pthread_t thread;
  ASSERT_EQ(pthread_create(&thread, &attributes, find_roots, nullptr), 0);
  EXPECT_EQ(pthread_join(thread, nullptr), 0);
  pthread_attr_destroy(&attributes);
}

// Catches odds that claim too much of short polynomials, too, which are not asked in doubles.
TEST(Odds, enclose_every_root_in_the_open_interval) {
  Random random(6);
  long certain = 0;
  for (long i = 0; i < 5000; ++i) {
    const IntegerPolynomial p = random_polynomial(random);
    std::vector<OddsBracket> brackets;
    if (p.is_zero() || !OddsPolynomial(p).find_roots(brackets)) continue;
    ++certain;
    auto roots = roots_by_bisection(p);
    std::erase_if(roots, [](const AlgebraicTime& t) { return t.bracket().lower == 1 || t.bracket().upper == 0; });
    ASSERT_EQ(roots.size(), brackets.size());
    for (std::size_t k = 0; k < roots.size(); ++k) {
      EXPECT_LT(brackets[k].lower_time(), roots[k].bracket().upper);
      EXPECT_GT(brackets[k].upper_time(), roots[k].bracket().lower);
      const IntegerPolynomial q = random_companion(p, random);
      const int sign = q.is_zero() ? 0 : OddsPolynomial(q).sign_between(brackets[k].low, brackets[k].high);
      EXPECT_TRUE(sign == 0 || sign == roots[k].sign_of(q));
    }
  }
  EXPECT_GT(certain, 1000);
}

// Catches times that are rounded inwards: at 1/2, among subnormals, next to 0 and next to 1.
TEST(Odds, are_between_their_doubles) {
  const auto around = [](double mantissa, long exponent) {
    return OddsBracket{{mantissa, exponent}, {mantissa, exponent}, 1};
  };
  for (long exponent = -1200; exponent < 1200; ++exponent)
    for (const double mantissa : {0.5, 0.75, 0.7071067811865476, 1.0}) {
      const OddsBracket bracket = around(mantissa, exponent);
      const double lower = bracket.lower_time(), upper = bracket.upper_time();
      ASSERT_TRUE(0 <= lower && lower < upper && upper <= 1) << exponent;
      // t > lower iff s (1 - lower) > lower; both sides times 2^3000 are integers.
      const auto integer = [](double x, long power) {
        int e = 0;
        const auto digits = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &e), 53));
        return Integer(digits) << static_cast<unsigned long>(e - 53 + power);
      };
      const Integer one = Integer(1) << 3000;
      const auto sign_beyond = [&](double t) {
        const Integer time = integer(t, 3000), s = integer(mantissa, 3000 + exponent);
        return (s * (one - time) - time * one).sign();
      };
      EXPECT_EQ(sign_beyond(lower), 1) << exponent;
      EXPECT_EQ(sign_beyond(upper), -1) << exponent;
      if (const auto cell = bracket.cell()) {
        EXPECT_LE(lower, lower_end(*cell));
        EXPECT_LE(lower_end({cell->n + 1, cell->k}), upper);
        EXPECT_LE(std::nextafter(lower_end(*cell), 2.0), upper);
      }
    }
}

}  // namespace
}  // namespace tamis::test

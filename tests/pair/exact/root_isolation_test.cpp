// Roots and signs at them, against the oracle's counting: polynomials whose coefficients have exponents of their own.
// TAMIS_EXACT_CASES sets the number of cases.
#include "pair/exact/root_isolation.hpp"

#include <gtest/gtest.h>
#include <pthread.h>

#include <algorithm>

#include "oracle/somewhere.hpp"
#include "scenes/random.hpp"
#include "support/test_data.hpp"
#include "support/to_oracle.hpp"

namespace tamis::test {
namespace {

using oracle::Rational;
using scenes::Random;
using test::to_oracle;

oracle::Polynomial to_oracle(const IntegerPolynomial& p) {
  std::vector<oracle::Integer> powers;
  for (int i = 0; i <= p.degree(); ++i) powers.push_back(to_oracle(p[i]));
  return oracle::Polynomial(std::move(powers));
}

/// In [n, n+1] / 2^k without its ends.
std::ptrdiff_t count_roots(const oracle::Polynomial& p, const DyadicCell& cell) {
  const auto part = p.on_part(to_oracle(cell.n), static_cast<unsigned>(cell.k)).primitive().without_roots_at_ends();
  return oracle::count_roots(part);
}

/// Some are zero, some powers of two: roots at the ends, and terms that are equally large.
Integer random_coefficient(Random& random, Index spread) {
  const Index kind = random.below(8);
  const std::int64_t size = kind == 0 ? 0 : kind == 1 ? 1 : std::int64_t{1} + random.below(1 << 30);
  return Integer(random.coin() ? size : -size) << random.below(spread);
}

template <std::size_t N>
IntegerPolynomial random_polynomial(Random& random, Index spread) {
  std::array<Integer, N> bernstein;
  for (Integer& b : bernstein) b = random_coefficient(random, spread);
  return IntegerPolynomial::from_bernstein(bernstein);
}

/// Some have roots of several multiplicities.
IntegerPolynomial random_polynomial(Random& random) {
  constexpr std::array<Index, 5> kSpreads{2, 40, 300, 2000, 6000};
  const Index spread = kSpreads[static_cast<std::size_t>(random.below(Index{kSpreads.size()}))];
  switch (random.below(4)) {
    case 0:
      return random_polynomial<3>(random, spread);
    case 1:
      return random_polynomial<4>(random, spread);
    case 2:
      return random_polynomial<7>(random, spread);
    default:
      const auto factor = random_polynomial<3>(random, spread);
      return factor * factor * random_polynomial<3>(random, spread);
  }
}

void expect_all_roots(const IntegerPolynomial& p) {
  const oracle::Polynomial expected = to_oracle(p);
  std::vector<AlgebraicTime> roots = roots_in_unit_interval(p);
  std::vector<double> starts;  // of the gaps between neighbouring doubles that hold roots
  std::ptrdiff_t doubles = 0;
  for (const AlgebraicTime& root : roots) {
    const auto [lower, upper] = root.bracket();
    if (lower < upper) {
      starts.push_back(lower);
      continue;
    }
    ++doubles;
    EXPECT_EQ(expected.sign_at(Rational(lower)), 0);
  }
  EXPECT_TRUE(std::is_sorted(starts.begin(), starts.end()));
  for (const double start : starts)
    EXPECT_EQ(count_roots(expected, cell_above(start)), std::count(starts.begin(), starts.end(), start)) << start;
  const std::ptrdiff_t at_ends = (expected.sign_at(0) == 0 ? 1 : 0) + (expected.sign_at(1) == 0 ? 1 : 0);
  EXPECT_EQ(std::ssize(starts) + doubles, count_roots(expected, {0, 0}) + at_ends);
}

// Catches a root that is lost, found twice or put beside its place.
TEST(Roots, are_those_that_the_oracle_counts) {
  Random random(5);
  for (long i = 5 * repetitions("TAMIS_EXACT_CASES", 200); i > 0 && !testing::Test::HasFailure(); --i)
    if (const IntegerPolynomial p = random_polynomial(random); !p.is_zero()) expect_all_roots(p);
}

/// n / 2^k, or as far from 1; n may be 0, and k is up to 3000.
struct Root {
  Integer n;
  int k;
  Rational time() const { return Rational(to_oracle(n), oracle::Integer(1) << k); }
};

Root random_root(Random& random) {
  const int k = 40 + random.below(random.coin() ? 100 : 3000);
  const Integer distance = std::int64_t{random.below(1 << 30)};
  return {random.coin() ? distance : (Integer(1) << k) - distance, k};
}

/// 2^k t - n
IntegerPolynomial factor(const Root& root) {
  return IntegerPolynomial::from_bernstein<2>({-root.n, (Integer(1) << root.k) - root.n});
}

// Catches a wrong sign at a root: of a polynomial with the same root, one very near, or one in the same gap of doubles.
TEST(Signs, at_known_roots_at_any_distance_are_right) {
  Random random(6);
  for (long i = 5 * repetitions("TAMIS_EXACT_CASES", 200); i > 0 && !testing::Test::HasFailure(); --i) {
    const Root known[] = {random_root(random), random_root(random), random_root(random)};
    const IntegerPolynomial p = factor(known[0]) * factor(known[1]) * factor(known[2]);
    std::vector<Rational> times;
    for (const Root& root : known) times.push_back(root.time());
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    std::vector<AlgebraicTime> roots = roots_in_unit_interval(p);
    ASSERT_EQ(roots.size(), times.size());
    const Root near{(known[0].n << 50) + (random.coin() ? 1 : -1), known[0].k + 50};
    for (const auto& q : {factor(known[0]), factor(near) * factor(random_root(random)), random_polynomial(random)})
      for (std::size_t k = 0; k < roots.size(); ++k) EXPECT_EQ(roots[k].sign_of(q), to_oracle(q).sign_at(times[k]));
  }
}

// Catches cells halved by calls within calls, as many as exponents have bits: threads have small stacks.
TEST(Roots, need_little_stack) {
  const auto find_roots = [](void*) -> void* {
    Random random(5);
    for (int i = 0; i < 500; ++i)
      if (const IntegerPolynomial p = random_polynomial(random); !p.is_zero()) roots_in_unit_interval(p);
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

}  // namespace
}  // namespace tamis::test

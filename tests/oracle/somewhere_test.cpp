#include "oracle/somewhere.hpp"

#include <gtest/gtest.h>

#include <random>

namespace tamis::oracle {
namespace {

Polynomial poly(std::vector<Integer> coefficients) { return Polynomial(std::move(coefficients)); }
Condition positive(Polynomial p) { return {std::move(p), Relation::positive}; }
Condition not_negative(Polynomial p) { return {std::move(p), Relation::not_negative}; }

bool has_root(const Polynomial& p, Range range = Range::closed) { return holds_somewhere(p, {}, range); }

TEST(Somewhere, FindsRootsInsideAndAtBothEndsOnly) {
  EXPECT_TRUE(has_root(poly({-1, 2})));
  EXPECT_TRUE(has_root(poly({0, 1})));
  EXPECT_TRUE(has_root(poly({-1, 1})));
  EXPECT_FALSE(has_root(poly({1, 2})));
  EXPECT_FALSE(has_root(poly({-3, 2})));
  EXPECT_FALSE(has_root(poly({5})));
}

TEST(Somewhere, LeavesOutTheLastPointOfAHalfOpenRange) {
  EXPECT_FALSE(has_root(poly({-1, 1}), Range::half_open));
  EXPECT_TRUE(has_root(poly({0, 1}), Range::half_open));
  EXPECT_FALSE(holds_somewhere(poly({-1, 1}) * poly({-1, 1}), {}, Range::half_open));
}

TEST(Somewhere, FindsDoubleAndTripleRoots) {
  const Polynomial p = poly({-1, 3});
  EXPECT_TRUE(has_root(p * p));
  EXPECT_TRUE(has_root(p * p * p));
  EXPECT_TRUE(has_root(p * p * poly({0, 1}) * poly({-1, 1}), Range::half_open));
}

// t = sqrt(1/2): the conditions are decided at an irrational number.
TEST(Somewhere, DecidesSignsAtIrrationalRoots) {
  const Polynomial p = poly({-1, 0, 2});
  EXPECT_TRUE(holds_somewhere(p, {positive(poly({-7, 10}))}, Range::closed));
  EXPECT_FALSE(holds_somewhere(p, {positive(poly({-8, 10}))}, Range::closed));
  EXPECT_TRUE(holds_somewhere(p, {not_negative(p), not_negative(-p)}, Range::closed));
  EXPECT_FALSE(holds_somewhere(p, {positive(p)}, Range::closed));
}

TEST(Somewhere, AsksAllConditionsOfOneAndTheSameRoot) {
  const Polynomial p = poly({-1, 4}) * poly({-3, 4});
  EXPECT_TRUE(holds_somewhere(p, {positive(poly({1, -2}))}, Range::closed));
  EXPECT_TRUE(holds_somewhere(p, {positive(poly({-1, 2}))}, Range::closed));
  EXPECT_FALSE(holds_somewhere(p, {positive(poly({1, -2})), positive(poly({-1, 2}))}, Range::closed));
}

// Bug: a shortcut that contradicts counting. Random polynomials, and conditions that vanish at a root, or nearly.
TEST(Somewhere, QuickWaysAgreeWithCounting) {
  std::mt19937 engine(3);
  const auto number = [&](int limit) {
    return static_cast<int>(engine() % static_cast<unsigned>(2 * limit + 1)) - limit;
  };
  const auto random_poly = [&](int degree) {
    std::vector<Integer> c;
    for (int i = 0; i <= degree; ++i) c.emplace_back(number(9));
    return poly(std::move(c));
  };
  int held = 0;
  for (int i = 0; i < 20000; ++i) {
    Polynomial p = random_poly(1 + i % 4);
    if (p.is_zero()) continue;
    p = p.without_roots_at_ends();
    Polynomial q = random_poly(2);
    if (i % 3 == 0) q = q * p;
    if (i % 5 == 0) q = q * poly({Integer(1) << 90}) + random_poly(1);
    const std::vector<Condition> conditions{i % 2 ? positive(q) : not_negative(q), not_negative(random_poly(1))};
    const bool counted = holds_at_counted_root(p, conditions);
    // Without roots at its ends, p is asked about its inner roots only.
    EXPECT_EQ(holds_somewhere(p, conditions, Range::closed), counted) << i;
    held += counted;
  }
  EXPECT_GT(held, 1000);
}

TEST(Somewhere, WithoutAnEquationFindsThinAndSinglePointSets) {
  const Polynomial zero;
  // 0 < t - 1/2 < 1/1000 and the single point 1/3.
  EXPECT_TRUE(holds_somewhere(zero, {positive(poly({-1, 2})), positive(poly({501, -1000}))}, Range::closed));
  EXPECT_FALSE(holds_somewhere(zero, {positive(poly({-1, 2})), positive(poly({499, -1000}))}, Range::closed));
  EXPECT_TRUE(holds_somewhere(zero, {not_negative(poly({-1, 3})), not_negative(poly({1, -3}))}, Range::closed));
  EXPECT_FALSE(holds_somewhere(zero, {positive(poly({-1, 3})), not_negative(poly({1, -3}))}, Range::closed));
  EXPECT_TRUE(holds_somewhere(zero, {}, Range::closed));
  EXPECT_FALSE(holds_somewhere(zero, {positive(zero)}, Range::closed));
  EXPECT_TRUE(holds_somewhere(zero, {not_negative(zero)}, Range::closed));
}

}  // namespace
}  // namespace tamis::oracle

#include "oracle/somewhere.hpp"

#include <gtest/gtest.h>

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

#include "search/query/body_pairs.hpp"

#include <gtest/gtest.h>

namespace tamis::test {
namespace {

TEST(BodyPairs, AreNumberedFromEitherSide) {
  const BodyPairs pairs(4, {0, 0, 1, 2, 3, 3}, {{0, 2}, {0, 3}, {1, 1}, {1, 3}});
  ASSERT_EQ(pairs.count(), 4u);
  EXPECT_EQ(pairs.number_of(0, 3), 0u);
  EXPECT_EQ(pairs.number_of(3, 1), 0u);
  EXPECT_EQ(pairs.number_of(5, 1), 1u);
  EXPECT_EQ(pairs.number_of(2, 2), 2u);
  EXPECT_EQ(pairs.number_of(2, 4), 3u);
}

TEST(BodyPairs, OthersHaveNoNumber) {
  const BodyPairs pairs(4, {0, 1, 2, 3}, {{0, 2}, {1, 3}});
  for (const auto& [a, b] : {std::array<Index, 2>{0, 1}, {0, 3}, {1, 2}, {2, 3}, {0, 0}, {3, 3}})
    EXPECT_EQ(pairs.number_of(a, b), pairs.count()) << a << " and " << b;
}

}  // namespace
}  // namespace tamis::test

// Would catch: a feature lost or doubled, which no query would find any more; a group torn apart; a cut at another
// rank, which makes blocks overlap.
#include "search/bvh/spatial_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace tamis {
namespace {

using Rng = std::mt19937_64;

struct Case {
  std::size_t count;
  unsigned places;                ///< on each axis; few: many centers are equal
  std::vector<std::size_t> ends;  ///< of groups
};

Case random_case(Rng& rng) {
  Case c{static_cast<std::size_t>(1 + rng() % (rng() % 4 ? 400 : 20000)), 1 + static_cast<unsigned>(rng() % 2000), {}};
  const std::size_t groups = rng() % 6;
  for (std::size_t i = 1; i < groups; ++i) c.ends.push_back(rng() % (c.count + 1));
  if (groups > 0) c.ends.push_back(c.count);
  std::ranges::sort(c.ends);
  return c;
}

template <int axes>
std::vector<Center<axes>> ordered(const Case& c, Rng rng) {
  std::vector<Center<axes>> centers(c.count);
  for (std::size_t i = 0; i < c.count; ++i) {
    for (float& x : centers[i].at) x = static_cast<float>(rng() % c.places) / static_cast<float>(c.places);
    centers[i].feature = static_cast<Index>(i);
  }
  order_in_space<axes>(
      centers, [] {}, c.ends);
  return centers;
}

template <int axes>
void expect_all_in_their_groups(const Case& c, const Rng& rng) {
  std::vector<Index> order;
  for (const auto& center : ordered<axes>(c, rng)) order.push_back(center.feature);
  std::vector<std::size_t> ends = c.ends;
  ends.push_back(c.count);
  std::size_t begin = 0;
  for (const std::size_t end : ends) {
    std::sort(order.begin() + static_cast<std::ptrdiff_t>(begin), order.begin() + static_cast<std::ptrdiff_t>(end));
    for (std::size_t i = begin; i < end; ++i) ASSERT_EQ(order[i], static_cast<Index>(i)) << c.count;
    begin = end;
  }
}

TEST(SpatialOrder, HasEveryFeatureOnceInItsGroup) {
  Rng rng(1);
  for (int repeat = 0; repeat < 300; ++repeat) {
    const Case c = random_case(rng);
    expect_all_in_their_groups<3>(c, rng);
    expect_all_in_their_groups<6>(c, rng);
    rng.discard(7);
  }
}

TEST(SpatialOrder, CutsAtTheRankAlongTheLongestAxis) {
  Rng rng(2);
  for (const std::size_t count : {std::size_t{17}, std::size_t{32}, std::size_t{200}, std::size_t{5000}})
    for (const unsigned places : {1u, 3u, 100u, 100000u}) {
      std::vector<Center<3>> centers(count);
      for (std::size_t i = 0; i < count; ++i)
        centers[i] = {{0, static_cast<float>(rng() % places), 0}, static_cast<Index>(i)};
      order_in_space<3>(centers, [] {});
      float before = -1;  // the largest of the blocks before
      for (std::size_t first = 0; first < count; first += 16) {
        const std::size_t end = std::min(first + 16, count);
        float most = before;
        for (std::size_t i = first; i < end; ++i) {
          ASSERT_GE(centers[i].at[1], before) << count << " centers in " << places << " places";
          most = std::max(most, centers[i].at[1]);
        }
        before = most;
      }
    }
}

}  // namespace
}  // namespace tamis

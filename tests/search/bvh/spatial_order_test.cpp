// Would catch: a feature lost or doubled, which no question would find any more; a group torn apart; an order that
// hangs on the instruction set.
#include "search/bvh/spatial_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "support/kernels_here.hpp"

namespace tamis {
namespace {

using Rng = std::mt19937_64;

struct Case {
  std::size_t count;
  int axes;
  unsigned places;                ///< on each axis; few: many centers are equal
  std::vector<std::size_t> ends;  ///< of groups
};

Case random_case(Rng& rng) {
  Case c{1 + rng() % (rng() % 4 ? 400 : 20000), rng() % 2 ? 3 : 6, 1 + static_cast<unsigned>(rng() % 2000), {}};
  const std::size_t groups = rng() % 6;
  for (std::size_t i = 1; i < groups; ++i) c.ends.push_back(rng() % (c.count + 1));
  if (groups > 0) c.ends.push_back(c.count);
  std::ranges::sort(c.ends);
  return c;
}

std::vector<Index> ordered(const Case& c, const Kernels& kernels, Rng rng) {
  CenterStore store(c.count, c.axes);
  const Centers centers = store.view();
  for (std::size_t i = 0; i < c.count; ++i) {
    for (int axis = 0; axis < c.axes; ++axis)
      centers.at[axis][i] = static_cast<float>(rng() % c.places) / static_cast<float>(c.places);
    centers.feature[i] = static_cast<Index>(i);
  }
  order_in_space(
      centers, c.count, kernels.trees.split, [] {}, c.ends);
  return {store.features().begin(), store.features().end()};
}

TEST(SpatialOrder, EveryFeatureComesOnceInItsGroupOnEveryInstructionSet) {
  Rng rng(1);
  for (int repeat = 0; repeat < 300; ++repeat) {
    const Case c = random_case(rng);
    const std::vector<Index> order = ordered(c, kernels(Isa::baseline), rng);
    for (const Isa isa : test::every_isa()) {
      const Kernels* here = test::kernels_here(isa);
      if (!here) continue;
      ASSERT_EQ(ordered(c, *here, rng), order) << c.count;
    }
    std::vector<std::size_t> ends = c.ends;
    ends.push_back(c.count);
    std::size_t begin = 0;
    for (const std::size_t end : ends) {
      std::vector<Index> group(order.begin() + static_cast<std::ptrdiff_t>(begin),
                               order.begin() + static_cast<std::ptrdiff_t>(end));
      std::ranges::sort(group);
      for (std::size_t i = begin; i < end; ++i) ASSERT_EQ(group[i - begin], static_cast<Index>(i)) << c.count;
      begin = end;
    }
    rng.discard(7);
  }
}

}  // namespace
}  // namespace tamis

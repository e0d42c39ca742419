// Would catch: a center lost or doubled, the wrong axis, a split off by one, a write beyond the part that is split.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "kernels/kernels.hpp"
#include "tamis/error.hpp"

namespace tamis {
namespace {

using Rng = std::mt19937_64;
using Coordinate = float (*)(Rng&);

float anywhere(Rng& rng) { return std::uniform_real_distribution<float>(-1, 1)(rng); }
float on_a_grid(Rng& rng) { return static_cast<float>(rng() % 5) / 4 - 0.5f; }
float in_one_place(Rng&) { return 0.25f; }
float mostly_equal(Rng& rng) { return rng() % 50 == 0 ? anywhere(rng) : 0.0f; }

struct Case {
  std::size_t count, lower;
};

constexpr std::size_t kBefore = 3, kAfter = 40;

/// Centers whose longest axis is `axis`, with others around them that must stay.
CenterStore items_along(int axis, int axes, std::size_t count, Coordinate coordinate, Rng& rng) {
  CenterStore store(kBefore + count + kAfter, axes);
  const Centers all = store.view();
  for (std::size_t i = 0; i < store.features().size(); ++i) {
    for (int k = 0; k < axes; ++k) all.at[k][i] = coordinate(rng) * (k == axis ? 1.0f : 0.5f);
    all.feature[i] = static_cast<Index>(i);
  }
  all.at[axis][kBefore] = -1;
  all.at[axis][kBefore + 1] = 1;
  return store;
}

void expect_split(const Kernels& kernels, const Case& c, int axis, int axes, Coordinate coordinate, Rng& rng) {
  CenterStore before = items_along(axis, axes, c.count, coordinate, rng), after = before, scratch = before;
  kernels.trees.split(after.view().from(kBefore), scratch.view().from(kBefore), c.count, c.lower);
  const Centers was = before.view(), is = after.view();
  std::vector<Index> features(after.features().begin(), after.features().end());
  for (std::size_t i = 0; i < features.size(); ++i) {
    const auto home = static_cast<std::size_t>(features[i]);
    for (int k = 0; k < axes; ++k) ASSERT_EQ(is.at[k][i], was.at[k][home]) << "a center was torn apart";
    const bool is_outside = i < kBefore || i >= kBefore + c.count;
    ASSERT_TRUE(!is_outside || home == i) << "a neighbour was moved";
    ASSERT_TRUE(!is_outside || scratch.features()[i] == static_cast<Index>(i)) << "a neighbour's scratch was used";
  }
  std::sort(features.begin(), features.end());
  for (std::size_t i = 0; i < features.size(); ++i) ASSERT_EQ(features[i], static_cast<Index>(i));
  const float* along = is.at[axis] + kBefore;
  // Ranks are those of the leading digits.
  ASSERT_LE(*std::max_element(along, along + c.lower), *std::min_element(along + c.lower, along + c.count) + 1e-3f);
}

class Splitting : public testing::TestWithParam<Isa> {};

TEST_P(Splitting, TheLowerOnesComeFirstAndNothingIsLost) {
  const Kernels* kernels = nullptr;
  try {
    kernels = &tamis::kernels(GetParam());
  } catch (const InvalidOptions& error) {
    GTEST_SKIP() << error.what();
  }
  Rng rng(1);
  const Case cases[] = {{17, 16}, {31, 16},   {32, 16},   {33, 32},    {64, 32},     {65, 48},
                        {80, 48}, {257, 256}, {511, 256}, {1000, 512}, {4111, 2304}, {20000, 12288}};
  for (const Case& c : cases)
    for (const int axes : {3, 6})
      for (int axis = 0; axis < axes; ++axis)
        for (const Coordinate coordinate : {anywhere, on_a_grid, mostly_equal})
          for (int repeat = 0; repeat < 4; ++repeat) expect_split(*kernels, c, axis, axes, coordinate, rng);
  for (const Case& c : cases) expect_split(*kernels, c, 0, 3, in_one_place, rng);
}

INSTANTIATE_TEST_SUITE_P(Isas, Splitting, testing::Values(Isa::baseline, Isa::avx2, Isa::avx512));

}  // namespace
}  // namespace tamis

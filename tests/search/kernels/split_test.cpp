// Would catch: a center lost or doubled, the wrong axis, a split off by one, a write beyond the part that is split.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include "support/kernels_here.hpp"

namespace tamis {
namespace {

using Rng = std::mt19937_64;
using Coordinate = std::function<float(Rng&)>;

float anywhere(Rng& rng) { return std::uniform_real_distribution<float>(-1, 1)(rng); }
float on_a_grid(Rng& rng) { return static_cast<float>(rng() % 5) / 4 - 0.5f; }
float in_one_place(Rng&) { return 0.25f; }
/// Powers of two from 1 to 2^-99, which crowd towards 0 at every scale.
float ever_closer(Rng& rng) { return std::ldexp(1.0f, -static_cast<int>(rng() % 100)); }
float mostly_equal(Rng& rng) { return rng() % 50 == 0 ? anywhere(rng) : 0.0f; }

struct Case {
  std::size_t count, lower;
};

constexpr std::size_t kBefore = 3, kAfter = 40;

/// The centers that are split, with others before and after them that must not change.
struct Items {
  CenterStore store;
  Centers all, in_question;

  Items(std::size_t count, int axes)
      : store(kBefore + count + kAfter, axes), all(store.view()), in_question(all.from(kBefore)) {}
};

/// Places the items so that `axis` is their longest axis.
void place(const Items& items, std::size_t count, int axis, const Coordinate& coordinate, Rng& rng) {
  for (std::size_t i = 0; i < items.store.features().size(); ++i) {
    for (int k = 0; k < items.all.axes; ++k) items.all.at[k][i] = coordinate(rng) * (k == axis ? 1.0f : 0.5f);
    items.all.feature[i] = static_cast<Index>(i);
  }
  const std::size_t longest = rng() % (count - 1);
  items.in_question.at[axis][longest] = -1;
  items.in_question.at[axis][longest + 1] = 1;
}

/// The expected order: features sorted stably by place along the axis, cut at `lower`, each part in its old order.
std::vector<Index> features_in_order(const Centers& centers, std::size_t count, std::size_t lower, int axis) {
  std::vector<Index> order(centers.feature, centers.feature + count);
  const float* along = centers.at[axis] - kBefore;
  std::ranges::stable_sort(order, std::less(), [&](Index i) { return along[i]; });
  std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(lower));
  std::sort(order.begin() + static_cast<std::ptrdiff_t>(lower), order.end());
  return order;
}

float length_along(int axis, const Centers& centers, std::size_t count) {
  const auto [low, high] = std::minmax_element(centers.at[axis], centers.at[axis] + count);
  return *high - *low;
}

void expect_same_centers(const Centers& was, const Centers& is, std::size_t first, std::size_t last,
                         const Index* features) {
  for (std::size_t i = first; i < last; ++i) {
    ASSERT_EQ(is.feature[i], features[i]) << "at " << i;
    for (int k = 0; k < was.axes; ++k)
      ASSERT_EQ(is.at[k][i], was.at[k][features[i]]) << "a center was torn apart, at " << i;
  }
}

void expect_split(const Kernels& kernels, const Case& c, int axis, int axes, const Coordinate& coordinate, Rng& rng) {
  const Items before(c.count, axes), after(c.count, axes), scratch(c.count, axes);
  const Rng same = rng;
  for (const Items* items : {&before, &after, &scratch}) place(*items, c.count, axis, coordinate, rng = same);
  ExtentBounds extents;
  for (int k = 0; k < Centers::kMostAxes; ++k) {
    extents.along[k] = std::numeric_limits<float>::infinity();
    if (k < axes && rng() % 2)
      extents.along[k] = length_along(k, before.in_question, c.count) * (rng() % 2 ? 1.0f : 1.5f);
  }
  const auto parts = kernels.trees.split(after.in_question, scratch.in_question, c.count, c.lower, extents);
  std::vector<Index> features = features_in_order(before.in_question, c.count, c.lower, axis);
  features.insert(features.begin(), {0, 1, 2});
  for (std::size_t i = 0; i < kAfter; ++i) features.push_back(static_cast<Index>(kBefore + c.count + i));
  const std::size_t middle = kBefore + c.lower, end = kBefore + c.count;
  expect_same_centers(before.all, after.all, 0, middle, features.data());
  expect_same_centers(before.all, scratch.all, middle, end + kAfter, features.data());
  expect_same_centers(before.all, after.all, end, end + kAfter, features.data());
  expect_same_centers(before.all, scratch.all, 0, kBefore, features.data());
  for (int k = 0; k < axes; ++k) {
    ASSERT_LE(length_along(k, after.in_question, c.lower), parts.low.along[k]);
    ASSERT_LE(length_along(k, scratch.in_question.from(c.lower), c.count - c.lower), parts.high.along[k]);
  }
}

class Splitting : public testing::TestWithParam<Isa> {};

TEST_P(Splitting, TheLowerOnesComeFirstAndBothKeepTheirOrder) {
  const Kernels* kernels = test::kernels_here(GetParam());
  if (!kernels) GTEST_SKIP() << "not on this machine";
  Rng rng(1);
  const Case cases[] = {{17, 16}, {31, 16},   {32, 16},   {33, 32},    {64, 32},     {65, 48},
                        {80, 48}, {257, 256}, {511, 256}, {1000, 512}, {4111, 2304}, {20000, 12288}};
  for (const Case& c : cases)
    for (const int axes : {3, 6})
      for (int axis = 0; axis < axes; ++axis)
        for (const Coordinate& coordinate : {Coordinate(anywhere), Coordinate(on_a_grid), Coordinate(ever_closer),
                                             Coordinate(mostly_equal), Coordinate(in_one_place)})
          expect_split(*kernels, c, axis, axes, coordinate, rng);
}

TEST_P(Splitting, AnyRankAmongNumbersOfWhichManyAreEqual) {
  const Kernels* kernels = test::kernels_here(GetParam());
  if (!kernels) GTEST_SKIP() << "not on this machine";
  Rng rng(2);
  for (int repeat = 0; repeat < 2000; ++repeat) {
    const std::size_t count = 2 + rng() % 3000, lower = 1 + rng() % (count - 1), places = 1 + rng() % 100;
    const auto on_places = [&](Rng& r) {  // the first places are more likely
      const double u = std::uniform_real_distribution<double>(0, 1)(r);
      return static_cast<float>(std::floor(u * u * u * static_cast<double>(places)) / static_cast<double>(places)) -
             0.5f;
    };
    ASSERT_NO_FATAL_FAILURE(expect_split(*kernels, {count, lower}, 0, 3, on_places, rng)) << count << ' ' << lower;
  }
}

INSTANTIATE_TEST_SUITE_P(Isas, Splitting, testing::ValuesIn(test::every_isa()));

}  // namespace
}  // namespace tamis

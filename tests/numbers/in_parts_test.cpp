#include "numbers/in_parts.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <random>

#include "numbers/counting_sort.hpp"
#include "support/threads.hpp"

namespace tamis {
namespace {

/// Runs f() with one thread, then with several, oneTBB's and lent ones.
template <class F>
void with_any_threads(const F& f) {
  for (const int threads : {1, 2, 5}) {
    SCOPED_TRACE(std::to_string(threads) + " threads");
    const test::AllowedThreads allowed(threads);
    test::EnginePool pool(threads - 1);
    Arena(threads, nullptr).run(f);
    Arena(threads, pool.lend()).run(f);
  }
}

constexpr std::size_t kGrain = 64;
constexpr std::size_t kCounts[] = {0, 1, kGrain, kGrain + 1, 10'000};

// Bug: an item that no part has, or two.
TEST(InParts, EachItemIsInOnePart) {
  with_any_threads([] {
    for (const std::size_t count : kCounts) {
      std::vector<int> times(count, 0);
      in_parts(count, kGrain, [&](std::size_t begin, std::size_t end) {
        for (; begin != end; ++begin) ++times[begin];
      });
      for_each_in_parts(std::span(times), kGrain, [](int& n) { ++n; });
      EXPECT_EQ(times, std::vector<int>(count, 2));
    }
  });
}

// Bug: what one part says is lost when it is joined.
TEST(InParts, JoinedPartsSayWhatAllSay) {
  with_any_threads([] {
    for (const std::size_t count : kCounts) {
      const auto sum = joined_parts(
          count, kGrain, std::size_t{0}, [](std::size_t a, std::size_t b) { return a + b; },
          [](std::size_t begin, std::size_t end) { return (end * (end - 1) - begin * (begin - 1)) / 2; });
      EXPECT_EQ(sum, count > 0 ? count * (count - 1) / 2 : 0);
    }
  });
}

// Bug: one item of which it is not so is passed over, wherever it is.
TEST(InParts, AllAreSoUnlessOneIsNot) {
  with_any_threads([] {
    std::vector<int> items(1000, 1);
    const auto are_all = [&] {
      return all_in_parts(std::span<const int>(items), kGrain, [](int item) { return item == 1; });
    };
    EXPECT_TRUE(are_all());
    for (int& item : items) {
      item = 0;
      EXPECT_FALSE(are_all());
      item = 1;
    }
  });
}

std::vector<std::uint32_t> random_numbers(std::size_t count, std::uint32_t below) {
  std::mt19937 random(7);
  std::vector<std::uint32_t> numbers(count);
  for (auto& number : numbers) number = std::uniform_int_distribution<std::uint32_t>(0, below - 1)(random);
  return numbers;
}

TEST(InParts, SortsAsStdDoes) {
  with_any_threads([] {
    for (const std::size_t count : kCounts) {
      auto numbers = random_numbers(count, 1000), expected = numbers;
      std::sort(expected.begin(), expected.end());
      sort_in_parts(numbers, std::less<>(), [] {});
      EXPECT_EQ(numbers, expected);
    }
  });
}

// Bugs: parts of the items put together in another order, counters of an earlier sort, ends of buckets that are another
// part's.
TEST(CountingSort, FindsPlacesByBucketThenInOrder) {
  with_any_threads([] {
    CountingSort sorter;
    for (const std::size_t count : kCounts)
      for (const std::uint32_t buckets : {1u, 3u, 5000u}) {
        const auto numbers = random_numbers(count, buckets);
        std::vector<std::size_t> expected(count), found(count, count);
        std::iota(expected.begin(), expected.end(), 0);
        std::stable_sort(expected.begin(), expected.end(),
                         [&](std::size_t a, std::size_t b) { return numbers[a] < numbers[b]; });
        sorter.find_places(
            count, buckets, [&](std::size_t i) { return numbers[i]; },
            [&](std::size_t i, std::size_t place) { found[place] = i; }, [] {});
        EXPECT_EQ(found, expected);
        for (std::uint32_t b = 0; b < buckets; ++b)
          for (std::size_t place = sorter.begin_of(b); place < sorter.end_of(b); ++place)
            EXPECT_EQ(numbers[found[place]], b);
        EXPECT_EQ(sorter.end_of(buckets - 1), count);
      }
  });
}

}  // namespace
}  // namespace tamis

#include "search/query/proximity_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "numbers/parallel.hpp"
#include "support/threads.hpp"

namespace tamis {
namespace {

/// Many share all vertices but the last.
std::vector<PairVertices> pairs_of(Index vertex_count, std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  const auto vertex = [&](Index among) { return std::uniform_int_distribution<Index>(0, among - 1)(random); };
  std::vector<PairVertices> pairs(count);
  for (PairVertices& pair : pairs) pair = {vertex(vertex_count), vertex(3), vertex(vertex_count), vertex(vertex_count)};
  return pairs;
}

void expect_sorted(const std::vector<PairVertices>& pairs, Index vertex_count, int threads) {
  std::vector<PairVertices> expected = pairs;
  std::sort(expected.begin(), expected.end());
  const test::AllowedThreads allowed(threads);
  test::EnginePool pool(threads - 1);
  for (const ParallelFor& lent : {ParallelFor(), pool.lend()}) {
    std::vector<PairVertices> sorted = pairs;
    ProximityOrder order;
    Arena(threads, lent).run([&] { order.sort(sorted, vertex_count); });
    EXPECT_EQ(sorted, expected) << vertex_count << " vertices, " << threads << " threads" << (lent ? ", lent" : "");
  }
}

TEST(ProximityOrder, IsThatOfTheVerticesWithAnyNumberOfThreads) {
  // Would catch a pass that is not stable, parts of the pairs put together in another order, and a last vertex that
  // is not looked at: few vertices make many parts, and many pairs that differ in nothing else.
  for (const int threads : {1, 2, 3, 7})
    for (const Index vertex_count : {3, 40, 5000})
      for (const std::size_t count : {0u, 1u, 2u, 20'000u})
        expect_sorted(pairs_of(vertex_count, count, static_cast<unsigned>(threads)), vertex_count, threads);
}

TEST(ProximityOrder, TakesPairsOfFewerThanFourVertices) {
  for (const std::size_t used : {2u, 3u}) {
    std::vector<PairVertices> pairs = pairs_of(50, 3000, 5);
    for (PairVertices& pair : pairs) std::fill(pair.begin() + used, pair.end(), -1);
    expect_sorted(pairs, 50, 2);
  }
}

}  // namespace
}  // namespace tamis

// Lists of pairs: nothing is lost, and what is there never moves.
#include "search/coherence/pair_lists.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace tamis {
namespace {

/// `count` pairs whose first corners are `first`, first + 1, ...
void add(Index first, int count, PairList& list) {
  const auto pairs = std::make_unique<PairBuffer>();
  for (pairs->count = 0; pairs->count < count; ++pairs->count) {
    pairs->corner[0][pairs->count] = first + pairs->count;
    pairs->t_in[pairs->count] = 0;
    pairs->t_out[pairs->count] = 1;
  }
  list.add(*pairs);
}

std::vector<Index> corners_of(const PairList& list) {
  std::vector<Index> corners;
  for (std::size_t i = 0; i < list.parts(); ++i)
    for (const Candidate& pair : list.part(i)) corners.push_back(pair.corners[0]);
  return corners;
}

std::vector<const Candidate*> places_of(const PairList& list) {
  std::vector<const Candidate*> places;
  for (std::size_t i = 0; i < list.parts(); ++i) places.push_back(list.part(i).data());
  return places;
}

constexpr Index kMany = 3 * 1024 + 7;

PairList list_of(Index first, Index count) {
  PairList list;
  for (Index i = 0; i < count; i += 100) add(first + i, std::min(100, count - i), list);
  return list;
}

std::vector<Index> numbers(Index count) {
  std::vector<Index> all;
  for (Index i = 0; i < count; ++i) all.push_back(i);
  return all;
}

// Bug: pairs at the border of two parts are lost, or a part grows without limit.
TEST(PairList, HasAllPairsInParts) {
  const PairList list = list_of(0, kMany);
  EXPECT_EQ(corners_of(list), numbers(kMany));
  EXPECT_EQ(list.parts(), 4u);
  EXPECT_FALSE(list.empty());
}

// Bug: a million pairs are copied when one more comes, and nobody looks meanwhile whether the question is cancelled.
TEST(PairList, MovesNothingWhenItGrows) {
  PairList list = list_of(0, kMany);
  const std::vector<const Candidate*> before = places_of(list);
  add(kMany, 2000, list);
  std::vector<const Candidate*> after = places_of(list);
  EXPECT_GT(after.size(), before.size());
  after.resize(before.size());
  EXPECT_EQ(after, before);
}

// Bug: taking a list copies it, loses pairs of either, or leaves them in both.
TEST(PairList, TakesTheOtherAsItIs) {
  PairList list = list_of(0, 2000), other = list_of(2000, 1500);
  std::vector<const Candidate*> places = places_of(list);
  for (const Candidate* place : places_of(other)) places.push_back(place);
  list.take(other);
  EXPECT_EQ(corners_of(list), numbers(3500));
  EXPECT_EQ(places_of(list), places);
  EXPECT_TRUE(other.empty());
  add(3500, 10, list);
  EXPECT_EQ(corners_of(list), numbers(3510));
}

// Bug: an emptied list keeps all its memory, or none, and every question allocates it anew.
TEST(PairList, KeepsOnePartWhenItIsCleared) {
  PairList list = list_of(0, kMany);
  list.clear();
  EXPECT_TRUE(list.empty());
  EXPECT_GT(list.memory_bytes(), 0u);
  EXPECT_LE(list.memory_bytes(), 1024 * sizeof(Candidate));
  PairList other = list_of(0, 5);
  list.take(other);
  EXPECT_EQ(corners_of(list), numbers(5));
}

}  // namespace
}  // namespace tamis

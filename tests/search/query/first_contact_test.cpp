// The first of many contacts is the same in whatever order they come, and however they are joined.
#include "search/query/first_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace tamis::test {
namespace {

struct Decided {
  Contact contact;
  bool by_integers;
};

Contact touching(double time, Index vertex, PairKind kind = PairKind::vertex_face) {
  return {kind, Certainty::certified, {vertex, 1000, 1001, 1002}, time, time, 0, 0, {0, 0, 1}};
}

EarliestContact first_of(const std::vector<Decided>& all, std::size_t parts) {
  std::vector<FirstContact> of_part(parts);
  for (std::size_t i = 0; i < all.size(); ++i) of_part[i % parts].add(all[i].contact, all[i].by_integers);
  FirstContact first;
  for (const FirstContact& part : of_part) {
    first.add(part);
    first.add(part);  // what a thread knows is told again after each sample
  }
  return first.answer();
}

/// The answer, if it is the same in many orders.
EarliestContact first_in_any_order(std::vector<Decided> all) {
  std::mt19937 random(5);
  const EarliestContact first = first_of(all, 1);
  for (int i = 0; i < 50; ++i) {
    std::shuffle(all.begin(), all.end(), random);
    const EarliestContact again = first_of(all, static_cast<std::size_t>(1 + i % 7));
    EXPECT_EQ(again.contact->vertices, first.contact->vertices);
    EXPECT_EQ(again.toi_lower, first.toi_lower);
    EXPECT_EQ(again.toi_upper, first.toi_upper);
  }
  return first;
}

/// As many pairs as given, within rounding of t = 1/2; those of higher number touch earlier.
std::vector<Decided> crowd(std::size_t count) {
  std::vector<Decided> all;
  for (std::size_t i = 0; i < count; ++i)
    all.push_back({touching(0.5 - 0x1p-52 * static_cast<double>(i), static_cast<Index>(i)), true});
  all.push_back({touching(0.75, 0), true});
  return all;
}

TEST(FirstContact, FewGoByTheirTimes) {
  const EarliestContact first = first_in_any_order(crowd(FirstContact::kCrowd - 1));
  EXPECT_EQ(first.contact->vertices[0], static_cast<Index>(FirstContact::kCrowd) - 2);
  EXPECT_EQ(first.toi_lower, first.contact->toi_lower);
}

TEST(FirstContact, ACrowdGoesByKindAndVertices) {
  const EarliestContact first = first_in_any_order(crowd(3 * FirstContact::kCrowd));
  EXPECT_EQ(first.contact->vertices[0], 0);
  EXPECT_LE(first.toi_lower, 0.5 - 0x1p-52 * 3 * FirstContact::kCrowd) << "all of them begin later";
  EXPECT_GT(first.toi_lower, 0.5 - 0x1p-39);
  EXPECT_EQ(first.toi_upper, 0.5);
}

TEST(FirstContact, OneBeforeTheCrowdIsFirst) {
  for (const bool by_integers : {false, true}) {
    auto all = crowd(3 * FirstContact::kCrowd);
    all.push_back({touching(0.25, 77, PairKind::edge_edge), by_integers});
    const EarliestContact first = first_in_any_order(all);
    EXPECT_EQ(first.contact->vertices[0], 77);
    EXPECT_EQ(first.toi_lower, 0.25);
  }
}

TEST(FirstContact, OnlyPairsBehindACrowdNeedNoExactTime) {
  FirstContact first;
  for (const Decided& one : crowd(FirstContact::kCrowd)) first.add(one.contact, one.by_integers);
  EXPECT_EQ(first.needed_until(PairKind::vertex_face, {-1, 0, 0, 0}, 0.6), 0.6);
  const double until = first.needed_until(PairKind::edge_edge, {0, 1, 2, 3}, 0.6);
  EXPECT_LT(until, 0.5);
  EXPECT_EQ(beginning_of(until), first.answer().toi_lower);
}

TEST(FirstContact, BeginningsAscendWithTimes) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> exponent(-40, 0);
  for (int i = 0; i < 100000; ++i) {
    const double time = i % 2 ? std::ldexp(1, -(i % 1000)) : std::exp2(exponent(random));
    const double begin = beginning_of(time), next = std::nextafter(time, 2);
    ASSERT_LE(begin, time);
    ASSERT_GE(begin, time * (1 - 0x1p-36));
    ASSERT_LE(begin, beginning_of(next));
    ASSERT_EQ(beginning_of(begin * (1 + 0x1p-49)), begin);
  }
  EXPECT_EQ(beginning_of(0), 0);
}

}  // namespace
}  // namespace tamis::test

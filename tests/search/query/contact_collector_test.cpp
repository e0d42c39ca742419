// Decided pairs become answers, in any order and by any thread.
#include "search/query/contact_collector.hpp"

#include <gtest/gtest.h>

#include "pair/narrow/decide.hpp"

namespace tamis::test {
namespace {

constexpr PairKind kKind = PairKind::vertex_face;
constexpr PairVertices kEarly{0, 3, 4, 5}, kLate{1, 3, 4, 5}, kResting{2, 3, 4, 5};

/// Vertex 0 falls through a face at t=1/4, vertex 1 at t=1/2; vertex 2 lies on it at t=0.
struct Collectors : testing::Test {
  std::vector<Point> start{{0.1, 0.1, 1}, {0.2, 0.2, 1}, {0.3, 0.3, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, end = start;
  Options options;
  const Rings rings{Mesh(6, {{3, 4, 5}}, {}, {0, 1, 2}), 1};
  Bound bound;
  ContactCollector one, other;
  std::optional<Query> query;

  void ask(Question question) {
    end[0][2] = -3;
    end[1][2] = -1;
    end[2][2] = 1;
    query.emplace(Query{{start, end}, {}, options.filter, rings, options.is_cancelled, question});
    bound.begin();
    one.begin(*query, bound);
    other.begin(*query, bound);
  }
  void add(ContactCollector& to, const PairVertices& vertices) {
    PrecisionCount count;
    to.add(kKind, vertices,
           decide({kKind, points_of(query->step, vertices), query->separations.between(kKind, vertices)}, count));
  }
};

TEST_F(Collectors, EarliestInAnyOrder) {
  ask(Question::earliest);
  add(one, kLate);
  add(one, kEarly);
  const EarliestContact first = one.first();
  ASSERT_TRUE(first.contact);
  EXPECT_EQ(first.contact->vertices, kEarly);
  EXPECT_LE(first.toi_lower, 0.25);
  EXPECT_GE(first.toi_upper, 0.25);
  ask(Question::earliest);
  add(one, kEarly);
  add(one, kLate);
  EXPECT_LT(bound.latest(), 0.2501) << "the late one can not be the first any more";
  const EarliestContact again = one.first();
  EXPECT_EQ(again.contact->vertices, kEarly);
  EXPECT_EQ(again.toi_lower, first.toi_lower);
  EXPECT_EQ(again.toi_upper, first.toi_upper);
}

TEST_F(Collectors, EarliestKnowsWhatOtherThreadsFound) {
  ask(Question::earliest);
  EXPECT_EQ(bound.latest(), 1);
  add(one, kEarly);
  EXPECT_LT(bound.latest(), 0.2501);
  add(other, kLate);
  other.take(one);
  EXPECT_EQ(other.first().contact->vertices, kEarly);
}

TEST_F(Collectors, NothingBehindAPairThatTouchesAtTheStart) {
  ask(Question::earliest);
  add(one, kResting);
  EXPECT_TRUE(one.is_choosy());
  EXPECT_TRUE(one.wants(kKind, kEarly)) << "an equal time would come first in the order of contacts";
  EXPECT_FALSE(one.wants(PairKind::edge_edge));
  EXPECT_TRUE(other.wants(PairKind::edge_edge));
  other.learn(one);
  EXPECT_FALSE(other.wants(PairKind::edge_edge));
}

/// Vertices 0 and 2 are one body, vertex 1 is another, the face a third.
TEST_F(Collectors, EachPairOfBodiesHasItsOwnFirstContact) {
  const BodyPairs bodies(3, {0, 1, 0, 2, 2, 2}, {{0, 2}, {1, 2}});
  ask(Question::earliest);
  query->each_of = &bodies;
  bound.begin(1, query->answers());
  one.begin(*query, bound);
  other.begin(*query, bound);
  add(one, kEarly);
  EXPECT_FALSE(other.wants(kKind, {0, 3, 4, 5}, 0.3));
  EXPECT_TRUE(other.wants(kKind, kLate, 0.3)) << "another body may touch later";
  EXPECT_FALSE(other.wants(kKind, {0, 1, 4, 5})) << "a pair of bodies that is not asked about";
  add(other, kLate);
  add(other, kResting);
  one.take(other);
  const std::vector<Contact> firsts = one.firsts();
  ASSERT_EQ(firsts.size(), 2u);
  EXPECT_EQ(firsts[0].vertices, kResting);
  EXPECT_EQ(firsts[1].vertices, kLate);
  EXPECT_LT(bound.latest(0), 1e-9);
  EXPECT_LT(bound.latest(1), 0.5001);
  EXPECT_EQ(bound.latest(), bound.latest(1));
}

TEST_F(Collectors, OneContactSettlesIsFree) {
  ask(Question::is_free);
  EXPECT_TRUE(other.wants(kKind));
  add(one, kLate);
  EXPECT_FALSE(other.wants(kKind));
  add(one, kEarly);
  EXPECT_EQ(one.contacts().size(), 1u);
  EXPECT_TRUE(bound.is_settled());
}

TEST_F(Collectors, AllContactsOfAllThreads) {
  ask(Question::all_contacts);
  add(one, kLate);
  add(other, kEarly);
  add(other, kResting);
  other.add(kKind, kLate, PairResult{});
  one.take(other);
  EXPECT_EQ(one.contacts().size(), 3u);
  EXPECT_TRUE(other.contacts().empty());
  EXPECT_EQ(bound.latest(), 1);
}

}  // namespace
}  // namespace tamis::test

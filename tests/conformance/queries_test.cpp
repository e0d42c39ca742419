// All published queries through the two calls for one pair.
#include <gtest/gtest.h>

#include "support/copied.hpp"
#include "support/test_data.hpp"
#include "support/yardstick/methods.hpp"
#include "tamis/pair.hpp"

namespace tamis::test {
namespace {

PairResult decide(const Query& q) {
  return q.kind == PairKind::vertex_face ? vertex_face(q.motion.start, q.motion.end)
                                         : edge_edge(q.motion.start, q.motion.end);
}

/// The pair as a mesh of its own, through all stages of a method.
std::vector<Contact> find(const Query& q, yardstick::Method method) {
  yardstick::Options options;
  options.method = method;
  options.threads = 1;
  options.filter.accepts = [&](PairKind kind, const std::array<Index, 4>& v) {
    return kind == q.kind && v == std::array<Index, 4>{0, 1, 2, 3};
  };
  const bool is_vf = q.kind == PairKind::vertex_face;
  Mesh mesh = is_vf ? Mesh(4, {{1, 2, 3}}, {}, {0}) : Mesh(4, {}, {{0, 1}, {2, 3}});
  const Positions start(q.motion.start), end(q.motion.end);
  return contacts_of(yardstick::make_detector(std::move(mesh), options), {start, end});
}

class Queries : public testing::Test {
 protected:
  void SetUp() override {
    if (data_folder().empty()) GTEST_SKIP() << kNoData;
    queries = read_queries(data_folder() / "queries");
    ASSERT_EQ(queries.size(), 38232u / 8);
  }
  std::vector<Query> queries;
};

// A stage that proves more than the decision all methods share, or less, shows here.
TEST_F(Queries, EveryMethodGivesTheAnswerOfTheOnePair) {
  for (const Query& q : queries) {
    const PairResult r = decide(q);
    for (const yardstick::Method method : {yardstick::Method::tamis, yardstick::Method::brute})
      ASSERT_EQ(find(q, method).size(), r.touches ? 1u : 0u) << name_of(method) << ": " << q.origin;
  }
}

TEST_F(Queries, AreAnsweredRightAndProven) {
  for (const Query& q : queries) {
    const PairResult r = decide(q);
    EXPECT_EQ(q.touches, r.touches) << q.origin;
    EXPECT_EQ(r.certainty, Certainty::certified) << q.origin;
  }
}

TEST_F(Queries, MotionBeforeTheBracketIsFreeAndContactsLieInIt) {
  for (const Query& q : queries) {
    const PairResult r = decide(q);
    if (!r.touches) continue;
    EXPECT_FALSE(r.toi_lower > 0 && oracle::touches(q.kind, q.motion, {0, r.toi_lower, true})) << q.origin;
    EXPECT_TRUE(oracle::touches(q.kind, q.motion, {r.toi_lower, r.toi_upper})) << q.origin;
  }
}

}  // namespace
}  // namespace tamis::test

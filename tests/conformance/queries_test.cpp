// All published queries through the two calls for one pair.
#include <gtest/gtest.h>

#include "support/test_data.hpp"
#include "tamis/pair.hpp"

namespace tamis::test {
namespace {

PairResult decide(const Query& q, Guarantee guarantee) {
  const PairOptions options{guarantee, 0};
  return q.kind == PairKind::vertex_face ? vertex_face(q.motion.start, q.motion.end, options)
                                         : edge_edge(q.motion.start, q.motion.end, options);
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

TEST_F(Queries, ConservativeMissesNoneAndIsWrongOnlyWhereUnresolved) {
  int unresolved = 0, false_positives = 0;
  for (const Query& q : queries) {
    const PairResult r = decide(q, Guarantee::conservative);
    EXPECT_LE(q.touches, r.touches) << "missed: " << q.origin;
    if (!r.touches) continue;
    EXPECT_TRUE(q.touches || r.certainty == Certainty::unresolved) << "certified, but free: " << q.origin;
    unresolved += r.certainty == Certainty::unresolved;
    false_positives += !q.touches;
  }
  RecordProperty("unresolved", unresolved);
  RecordProperty("false_positives", false_positives);
}

TEST_F(Queries, ExactIsRightEverywhere) {
  for (const Query& q : queries) {
    const PairResult r = decide(q, Guarantee::exact);
    EXPECT_EQ(q.touches, r.touches) << q.origin;
    EXPECT_EQ(r.certainty, Certainty::certified) << q.origin;
  }
}

TEST_F(Queries, MotionBeforeTheBracketIsFreeAndCertifiedContactsLieInIt) {
  for (const Query& q : queries)
    for (const Guarantee guarantee : {Guarantee::conservative, Guarantee::exact}) {
      const PairResult r = decide(q, guarantee);
      if (!r.touches) continue;
      EXPECT_FALSE(r.toi_lower > 0 && oracle::touches(q.kind, q.motion, {0, r.toi_lower, true})) << q.origin;
      if (r.certainty == Certainty::certified) {
        EXPECT_TRUE(oracle::touches(q.kind, q.motion, {r.toi_lower, r.toi_upper})) << q.origin;
      }
    }
}

}  // namespace
}  // namespace tamis::test

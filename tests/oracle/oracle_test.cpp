// The oracle judges everything else. Here it is judged itself: by cases that a reader can check, by symmetries, and by
// the published exact answers.
#include "oracle/oracle.hpp"

#include <gtest/gtest.h>

#include "support/pair_cases.hpp"
#include "support/test_data.hpp"

namespace tamis::test {
namespace {

constexpr auto kVf = PairKind::vertex_face;
constexpr auto kEe = PairKind::edge_edge;
using oracle::comes_within, oracle::touches, oracle::Motion;

/// A vertex at height `from` over a point (x, y), falling to height `to` on the resting face (0,0) (1,0) (0,1).
Motion falling(double x, double y, double from, double to) {
  const Point a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
  return {{{{x, y, from}, a, b, c}}, {{{x, y, to}, a, b, c}}};
}

TEST(Oracle, VertexFaceTouchesInsideOnBordersAndAtBothEndsOfTheStep) {
  EXPECT_TRUE(touches(kVf, falling(0.25, 0.25, 1, -1)));
  EXPECT_TRUE(touches(kVf, falling(0.25, 0.25, 1, 0)));
  EXPECT_TRUE(touches(kVf, falling(0.25, 0.25, 0, 1)));
  EXPECT_FALSE(touches(kVf, falling(0.25, 0.25, 1, 0x1p-1074)));
  EXPECT_TRUE(touches(kVf, falling(0.5, 0.5, 1, -1)));
  EXPECT_FALSE(touches(kVf, falling(0.5, 0.5 + 0x1p-53, 1, -1)));
  EXPECT_TRUE(touches(kVf, falling(0, 0, 1, -3)));
  EXPECT_FALSE(touches(kVf, falling(-0x1p-1074, 0, 1, -3)));
}

TEST(Oracle, VertexThatSlidesInThePlaneOfTheFaceTouchesWhenItEnters) {
  Motion m = falling(0, 0, 0, 0);
  m.start[0] = {-1, 0.5, 0};
  m.end[0] = {-0x1p-40, 0.5, 0};
  EXPECT_FALSE(touches(kVf, m));
  m.end[0] = {0, 0.5, 0};
  EXPECT_TRUE(touches(kVf, m));
  m.end[0] = {2, 0.5, 0};
  EXPECT_TRUE(touches(kVf, m));
  m.start[0] = {0.25, 0.25, 0};
  EXPECT_TRUE(touches(kVf, m));
}

TEST(Oracle, FaceWithoutAreaIsASegmentOrAPoint) {
  const Point a{0, 0, 0}, b{1, 0, 0}, c{2, 0, 0};
  Motion m{{{{1.5, 1, 0}, a, b, c}}, {{{1.5, -1, 0}, a, b, c}}};
  EXPECT_TRUE(touches(kVf, m));
  m.start[0][2] = 0x1p-30;
  EXPECT_FALSE(touches(kVf, m));
  m = {{{{1, 1, 1}, a, a, a}}, {{{-1, -1, -1}, a, a, a}}};
  EXPECT_TRUE(touches(kVf, m));
  m.end[0][0] = -1.5;
  EXPECT_FALSE(touches(kVf, m));
}

TEST(Oracle, EdgesTouchCrosswiseCollinearParallelAndAtTheirEnds) {
  const auto crossing = [](Point a0, Point a1, Point b0, Point b1) {
    return Motion{{{a0, a1, b0, b1}}, {{a0, a1, b0, b1}}};
  };
  EXPECT_TRUE(touches(kEe, crossing({-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0})));
  EXPECT_FALSE(touches(kEe, crossing({-1, 0, 0}, {1, 0, 0}, {0, -1, 0x1p-60}, {0, 1, 0x1p-60})));
  EXPECT_TRUE(touches(kEe, crossing({0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0})));
  EXPECT_FALSE(touches(kEe, crossing({0, 0, 0}, {1, 0, 0}, {1 + 0x1p-52, 0, 0}, {2, 0, 0})));
  EXPECT_FALSE(touches(kEe, crossing({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0})));
  EXPECT_TRUE(touches(kEe, crossing({0.5, 0, 0}, {0.5, 0, 0}, {0, 0, 0}, {1, 0, 0})));
  EXPECT_TRUE(touches(kEe, crossing({3, 2, 1}, {3, 2, 1}, {3, 2, 1}, {3, 2, 1})));
}

// Edge b turns about edge a, which lies on the x axis. Where b passes over a, its height is (2t-1)^2 / (2t+3).
TEST(Oracle, FindsADoubleRootThatASignChangeTestMisses) {
  const Point a0{-1, 0, 0}, a1{1, 0, 0};
  Motion m{{{a0, a1, {0, -1, -1}, {0, 2, 3}}}, {{a0, a1, {0, -1, 1}, {0, 4, -3}}}};
  EXPECT_TRUE(touches(kEe, m));
  EXPECT_TRUE(touches(kEe, m, {0.5, 0.5}));
  EXPECT_FALSE(touches(kEe, m, {0, 0.5, true}));
  EXPECT_FALSE(touches(kEe, m, {0.5 + 0x1p-50, 1}));
  for (auto* points : {&m.start, &m.end})
    for (std::size_t i : {2u, 3u}) (*points)[i][2] += 0x1p-50;
  EXPECT_FALSE(touches(kEe, m));
}

TEST(Oracle, PartsOfTheStepTogetherGiveTheStep) {
  Random random(1);
  for (const Family& family : kFamilies)
    for (const PairKind kind : {kVf, kEe})
      for (int i = 0; i < 40; ++i) {
        const Motion m = family.make(kind, random);
        const double cut = random.coin() ? random.unit() : 0.125 * random.below(9);
        EXPECT_EQ(touches(kind, m), touches(kind, m, {0, cut, true}) || touches(kind, m, {cut, 1}))
            << family.name << " cut at " << cut << " " << describe(kind, m);
      }
}

TEST(Oracle, SymmetriesKeepTheAnswer) {
  Random random(2);
  for (const Family& family : kFamilies)
    for (const PairKind kind : {kVf, kEe})
      for (int i = 0; i < 40; ++i) {
        const Motion m = family.make(kind, random);
        const bool answer = touches(kind, m);
        EXPECT_EQ(answer, touches(kind, permuted(kind, m, random))) << describe(kind, m);
        EXPECT_EQ(answer, touches(kind, Motion{m.end, m.start})) << describe(kind, m);
        // Scales up, not down, because a nudge of zero is the smallest double.
        EXPECT_EQ(answer, touches(kind, placed(m, {"", 0x1p900, 0}))) << describe(kind, m);
        if (i % 4 == 0) {
          EXPECT_EQ(answer, comes_within(kind, m, 0)) << describe(kind, m);
        }
      }
}

TEST(Oracle, KnownContactsTouch) {
  Random random(3);
  const Family& exact_contact = family_named("exact_contact");
  for (int i = 0; i < 300; ++i)
    for (const PairKind kind : {kVf, kEe}) {
      const Motion m = exact_contact.make(kind, random);
      EXPECT_TRUE(touches(kind, m)) << describe(kind, m);
    }
}

TEST(Oracle, DistanceIsThatToCornersSidesAndInside) {
  // The vertex is over the inside, beside a side, and beside a corner (3-4-5 triangles).
  EXPECT_TRUE(comes_within(kVf, falling(0.25, 0.25, 2, 1), 1));
  EXPECT_FALSE(comes_within(kVf, falling(0.25, 0.25, 2, 1 + 0x1p-52), 1));
  EXPECT_TRUE(comes_within(kVf, falling(0.5, -3, 8, 4), 5));
  EXPECT_FALSE(comes_within(kVf, falling(0.5, -3 - 0x1p-50, 8, 4), 5));
  EXPECT_TRUE(comes_within(kVf, falling(4, 0, 8, 4), 5));
  EXPECT_FALSE(comes_within(kVf, falling(4 + 0x1p-50, 0, 8, 4), 5));
  const Motion parallel{{{{0, 0, 0}, {1, 0, 0}, {0, 3, 0}, {1, 3, 0}}},
                        {{{0, 0, 0}, {1, 0, 0}, {9, 1, 0}, {10, 1, 0}}}};
  EXPECT_TRUE(comes_within(kEe, parallel, 3));
  EXPECT_FALSE(comes_within(kEe, parallel, 2.5));
}

// Bug: a conclusion from sampled distances that these do not prove.
TEST(Oracle, SampledDistancesChangeNoAnswer) {
  Random random(4);
  long near = 0;
  for (const Family& family : kFamilies)
    for (const PairKind kind : {kVf, kEe})
      for (int i = 0; i < 12; ++i) {
        const Motion m = permuted(kind, family.make(kind, random), random);
        const double separation = random.coin() ? 0.125 * random.below(8) : std::ldexp(random.unit(), -random.below(9));
        const oracle::Times times{0, random.coin() ? 1 : random.unit(), random.coin()};
        const bool answer = comes_within(kind, m, separation, times);
        near += answer;
        EXPECT_EQ(answer, oracle::comes_within_by_algebra(kind, m, separation, times)) << describe(kind, m);
      }
  EXPECT_GT(near, 60);
}

TEST(Oracle, AgreesWithAllPublishedQueries) {
  const auto folder = data_folder();
  if (folder.empty()) GTEST_SKIP() << kNoData;
  const auto queries = read_queries(folder / "queries");
  EXPECT_EQ(queries.size(), 38232u / 8);
  for (const Query& q : queries) EXPECT_EQ(touches(q.kind, q.motion), q.touches) << q.origin;
}

}  // namespace
}  // namespace tamis::test

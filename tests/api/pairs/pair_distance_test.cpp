// One pair: its distance, how long it keeps a part of this, and the latest time of interest. Would catch: an answer
// that differs from the detector's, a latest time that loses an earlier contact or changes a bracket.
#include "tamis/pair_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "support/ask_pair.hpp"
#include "support/pair_cases.hpp"
#include "tamis/detector.hpp"
#include "tamis/error.hpp"

namespace tamis {
namespace {

constexpr std::array<Index, 4> kAll{0, 1, 2, 3};

/// A detector for a mesh that has this pair and few others.
Detector detector_of(PairKind kind) {
  if (kind == PairKind::vertex_face) return Detector(Mesh(4, {{1, 2, 3}}, {}, {0}));
  if (kind == PairKind::edge_edge) return Detector(Mesh(4, {}, {{0, 1}, {2, 3}}));
  return Detector(Mesh(4, {}, {{1, 2}}, {0}));
}

TEST(PairDistance, IsWhatNearSaysOfThePair) {
  test::Random random(3);
  for (const PairKind kind : {PairKind::vertex_face, PairKind::edge_edge, PairKind::vertex_edge})
    for (int i = 0; i < 50; ++i) {
      const auto motion = test::family_named(i % 2 ? "random" : "lattice").make(kind, random);
      const std::vector<Point> points(motion.start.begin(), motion.start.end());
      const NearPair alone = distance_of({kind, kAll}, points);
      Detector detector = detector_of(kind);
      bool is_found = false;
      for (const NearPair& pair : detector.pairs_within(points, 1e3))
        if (pair.kind == kind) {
          is_found = true;
          EXPECT_EQ(alone.distance, pair.distance);
          EXPECT_EQ(std::pair(alone.u, alone.v), std::pair(pair.u, pair.v));
          EXPECT_EQ(alone.vertices, pair.vertices);
          EXPECT_EQ(alone.direction, pair.direction);
        }
      EXPECT_TRUE(is_found);
    }
}

TEST(PairDistance, OfTwoPointsIsTheirs) {
  const std::vector<Point> points{{9, 9, 9}, {1, 2, 3}, {1, 2, 7}};
  const NearPair pair = distance_of({PairKind::vertex_vertex, {1, 2, 99, -9}}, points);
  EXPECT_EQ(pair.distance, 4);
  EXPECT_EQ(pair.vertices, (std::array<Index, 4>{1, 2, -1, -1}));
}

TEST(PairDistance, AFractionIsKeptAsLongAsTheDetectorSays) {
  test::Random random(5);
  int limits = 0;
  for (const PairKind kind : {PairKind::vertex_face, PairKind::edge_edge})
    for (int i = 0; i < 200; ++i) {
      const auto motion = test::family_named("random").make(kind, random);
      const std::vector<Point> start(motion.start.begin(), motion.start.end()),
          end(motion.end.begin(), motion.end.end());
      for (const double fraction : {0.0, 0.1, 0.9}) {
        const SafeStep alone = safe_step({kind, kAll}, {start, end}, fraction, {.min_separation = 0.01});
        Detector detector = detector_of(kind);
        const SafeStep step = detector.safe_step({start, end}, fraction, {.min_separation = 0.01});
        EXPECT_EQ(alone.toi_lower, step.toi_lower);
        EXPECT_EQ(alone.toi_upper, step.toi_upper);
        ASSERT_EQ(alone.pair.has_value(), step.pair.has_value());
        if (!alone.pair) continue;
        ++limits;
        EXPECT_EQ(alone.pair->vertices, step.pair->vertices);
        EXPECT_EQ(alone.pair->distance, step.pair->distance);
        EXPECT_EQ(alone.pair->distance, distance_of({kind, kAll}, start).distance);
      }
    }
  EXPECT_GT(limits, 50);
}

// Bug: the distance is computed from closest points whose weights in doubles are far off for a needle; here it becomes
// five times too large.
TEST(PairDistance, BesideANeedleALimitsDistanceIsAsNearAsAnyOther) {
  const std::vector<Point> start{{0x1.59b29ede2363p+0, 0x1.ab718ead0b6fep-1, 0x1.b1fe423fd4a7dp+0},
                                 {0x1.363839086ab08p-2, 0x1.a87f63afa33e2p-1, 0x1.3c3f7e39aaa22p-1},
                                 {0x1.38ca48bfcac11p+1, 0x1.ae84bec715dfep-1, 0x1.68f8601d3bebep+1},
                                 {0x1.38c9a531422e8p+1, 0x1.ae84ba0c4e6cep-1, 0x1.68f7b89ab2061p+1}};
  std::vector<Point> end = start;
  for (std::size_t k = 0; k < 3; ++k)
    end[0][k] -= 0x1p-28 * distance_of({PairKind::vertex_face, kAll}, start).direction[k];
  Detector detector = detector_of(PairKind::vertex_face);
  for (const double keep : {0.0, 0.1}) {
    const SafeStep safe = detector.safe_step({start, end}, keep);
    ASSERT_TRUE(safe.pair);
    EXPECT_NEAR(safe.pair->distance, 9.1447e-10, 1e-12);
  }
}

// Bug: a pair that is apart at t=0, and has all of its distance then, is said to have lost it at that time.
TEST(PairDistance, APairThatIsApartAtTheStartHasAllOfItsDistanceThere) {
  const std::vector<Point> start{{0, 0, 0}, {0x1p-1074, 0, 0}}, end{{0x1p1000, 0, 0}, {0x1p-1074, 0, 0}};
  const SafeStep apart = safe_step({PairKind::vertex_vertex, {0, 1, -1, -1}}, {start, end}, 0.1);
  EXPECT_EQ(apart.toi_lower, 0);
  EXPECT_GT(apart.toi_upper, 0);
  const std::vector<Point> touching{{0, 0, 0}, {0, 0, 0}};
  const SafeStep none = safe_step({PairKind::vertex_vertex, {0, 1, -1, -1}}, {touching, end}, 0.1);
  EXPECT_EQ(none.toi_lower, 0);
  EXPECT_EQ(none.toi_upper, 0);
}

TEST(PairDistance, NothingAfterTheLatestTimeOfInterestMatters) {
  // A point goes from height 1 to -3 over a point at rest: half of the distance is left at t = 1/8.
  const std::vector<Point> start{{0, 0, 1}, {0, 0, 0}}, end{{0, 0, -3}, {0, 0, 0}};
  const FeaturePair pair{PairKind::vertex_vertex, {0, 1, -1, -1}};
  EXPECT_NEAR(safe_step(pair, {start, end}, 0.5).toi_lower, 0.125, 1e-6);
  const SafeStep early = safe_step(pair, {start, end}, 0.5, {.latest = 0.1});
  EXPECT_EQ(early.toi_lower, 0.1);
  EXPECT_FALSE(early.pair.has_value());
  EXPECT_EQ(safe_step(pair, {start, end}, 0, {.latest = 0.2}).toi_lower, 0.2);
  EXPECT_NEAR(safe_step(pair, {start, end}, 0, {.latest = 0.3}).toi_lower, 0.25, 1e-9);
}

TEST(FeaturePair, ALatestTimeOfInterestOnlyMakesLaterPairsFree) {
  test::Random random(11);
  int early = 0, late = 0;
  for (const auto& family : test::kFamilies)
    for (int i = 0; i < 40; ++i)
      for (const PairKind kind : test::kAllKinds) {
        const auto motion = family.make(kind, random);
        const PairResult whole = test::ask_pair(kind, motion, {});
        const PairResult part = test::ask_pair(kind, motion, {.latest = 0.5});
        EXPECT_EQ(part.touches, whole.touches && whole.toi_lower <= 0.5);
        if (part.touches) {
          EXPECT_EQ(part.toi_lower, whole.toi_lower);
          EXPECT_EQ(part.toi_upper, whole.toi_upper);
        }
        early += part.touches;
        late += whole.touches && !part.touches;
      }
  EXPECT_GT(early, 50);
  EXPECT_GT(late, 50);
}

TEST(PairDistance, BadInputIsNamed) {
  const std::vector<Point> points(4, Point{0, 0, 0}), fewer(3);
  const FeaturePair pair{PairKind::vertex_face, kAll};
  EXPECT_THROW((void)distance_of({PairKind::vertex_face, {0, 1, 2, 4}}, points), InvalidStep);
  EXPECT_THROW((void)distance_of({static_cast<PairKind>(7), kAll}, points), InvalidStep);
  EXPECT_THROW((void)safe_step(pair, {points, fewer}, 0.5), InvalidStep);
  EXPECT_THROW((void)safe_step(pair, {points, points}, 1), InvalidOptions);
  EXPECT_THROW((void)safe_step(pair, {points, points}, std::nan("")), InvalidOptions);
  for (const double latest : {-0.1, 1.5, std::nan("")})
    EXPECT_THROW((void)safe_step(pair, {points, points}, 0.5, {.latest = latest}), InvalidOptions);
  auto bad = points;
  bad[2][1] = std::numeric_limits<double>::infinity();
  try {
    (void)safe_step(pair, {points, bad}, 0.5);
    FAIL() << "nothing was thrown";
  } catch (const InvalidStep& e) {
    EXPECT_STREQ(e.what(),
                 "vertex 2 at the end of the step has a coordinate that is not finite: give finite positions");
  }
}

// Bug: a gap is 10^7 times as short as its features. At one time rounding tilts its axis, and for some fractions the
// step ended there. Samples in quadruple precision show that three quarters of the distance are left throughout.
TEST(PairDistance, ATinyGapDoesNotEndAStepThatKeepsIt) {
  const std::vector<Point> start{{0, 0, 0},
                                 {9.6390522383153439, -10.377899000421166, -6.5939824730157852},
                                 {9.6390831079334021, -10.377888936549425, -6.5939531866461039},
                                 {9.6391139775514603, -10.377878870815039, -6.5939239021390676}};
  const std::vector<Point> end{{1.1174008250236511e-05, -7.1823596954345703e-06, 8.322298526763916e-06},
                               {9.6390596386045218, -10.377905232831836, -6.5939948037266731},
                               {9.6390917394310236, -10.377895459532738, -6.5939418468624353},
                               {-1110.2547781504691, -565.18007609248161, 186.16064522042871}};
  for (const double keep : {0.05, 0.09, 0.1, 0.11, 0.125, 0.2, 0.3, 0.5, 0.7})
    EXPECT_EQ(safe_step({PairKind::edge_edge, {0, 1, 2, 3}}, {start, end}, keep).toi_lower, 1) << keep;
}

}  // namespace
}  // namespace tamis

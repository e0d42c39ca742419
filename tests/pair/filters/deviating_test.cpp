// DNF of motions that are not quite known: what it culls is free wherever the vertices deviate to, within their room.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pair/filters/dnf.hpp"
#include "support/pair_cases.hpp"
#include "support/test_data.hpp"

namespace tamis::test {
namespace {

using oracle::Motion;

bool culls(PairKind kind, const Motion& motion, double deviation) {
  const auto m = make_motion(kind, to_points(motion), deviation);  // a separation is scaled as the motion is
  return kind == PairKind::vertex_face ? Dnf::proves_free_though_deviating<PairKind::vertex_face>(m, m.separation)
                                       : Dnf::proves_free_though_deviating<PairKind::edge_edge>(m, m.separation);
}

/// Each coordinate as far as it may go, up or down; rounding leads to no farther place.
Motion deviated(Motion motion, double deviation, Random& random) {
  for (auto* points : {&motion.start, &motion.end})
    for (Point& point : *points)
      for (double& x : point) x += (random.coin() ? 1 : -1) * deviation * (1 - 0x1p-30);
  return motion;
}

// Bugs: a change of the determinant estimated too small, or in another unit than the motion.
TEST(DnfThoughDeviating, CulledPairsAreFreeWhereverTheyDeviateTo) {
  const long cases = repetitions("TAMIS_FILTER_CASES", 100);
  Random random(37);
  int culled = 0;
  for (const char* family : {"separated", "random", "near_contact"})
    for (const double scale : {1.0, 0x1p-9, 0x1p13})
      for (long i = 0; i < cases; ++i)
        for (const PairKind kind : {PairKind::vertex_face, PairKind::edge_edge}) {
          const Motion motion = placed(family_named(family).make(kind, random), {"", scale, 0});
          double deviation = scale;
          while (deviation > 0x1p-30 * scale && !culls(kind, motion, deviation)) deviation /= 1.5;
          if (!culls(kind, motion, deviation)) continue;
          ++culled;
          for (int k = 0; k < 8; ++k) {
            const Motion other = deviated(motion, deviation, random);
            EXPECT_FALSE(oracle::touches(kind, other)) << describe(kind, other) << ", deviation " << deviation;
          }
        }
  EXPECT_GT(culled, cases);
}

/// A point above a large face: only the heights matter, so the estimate can be compared with what is possible.
TEST(DnfThoughDeviating, KnowsNoMoreThanWhatDeviatesTogether) {
  const double height = 0x1p-6;
  const Motion motion{{{{0.25, 0.25, height}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                      {{{0.25, 0.25, height}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}};
  EXPECT_FALSE(culls(PairKind::vertex_face, motion, 0.5 * height)) << "both may deviate by half of the height";
  EXPECT_TRUE(culls(PairKind::vertex_face, motion, 0.01 * height)) << "nothing is ever proven";
  EXPECT_TRUE(culls(PairKind::vertex_face, motion, 0));
}

}  // namespace
}  // namespace tamis::test

#include "pair/motion/make_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/pair_cases.hpp"

namespace tamis::test {
namespace {

double largest_size(const PairMotion<double>& m) { return std::max({m.size_e, m.size_f, m.size_d}); }

double largest_component(const Moving<double>& v) {
  double largest = 0;
  for (double x : {v.at0.x, v.at0.y, v.at0.z, v.at1.x, v.at1.y, v.at1.z}) largest = std::max(largest, std::abs(x));
  return largest;
}

TEST(MakeMotion, BringsTheLargestSizeBetweenAHalfAndOneAtEveryScale) {
  Random random(1);
  for (const Placement& placement : kPlacements)
    for (const PairKind kind : {PairKind::vertex_face, PairKind::edge_edge})
      for (int i = 0; i < 100; ++i) {
        const auto motion = placed(family_named("random").make(kind, random), placement);
        const auto m = make_motion(kind, to_points(motion));
        EXPECT_GE(largest_size(m), 0.5) << placement.name;
        EXPECT_LT(largest_size(m), 1) << placement.name;
        EXPECT_EQ(m.size_e, largest_component(m.e));
        EXPECT_EQ(m.size_f, largest_component(m.f));
        EXPECT_EQ(m.size_d, largest_component(m.d));
      }
}

TEST(MakeMotion, PowersOfTwoChangeNoBit) {
  Random random(2);
  for (const PairKind kind : {PairKind::vertex_face, PairKind::edge_edge})
    for (int i = 0; i < 100; ++i) {
      const auto motion = family_named("random").make(kind, random);
      const auto m = make_motion(kind, to_points(motion));
      for (const double scale : {0x1p-500, 0x1p-20, 0x1p20, 0x1p900}) {
        const auto scaled = make_motion(kind, to_points(placed(motion, {"", scale, 0})));
        EXPECT_EQ(m.d.at0.x, scaled.d.at0.x);
        EXPECT_EQ(m.e.at1.y, scaled.e.at1.y);
        EXPECT_EQ(m.f.at0.z, scaled.f.at0.z);
        EXPECT_EQ(m.size_e, scaled.size_e);
      }
    }
}

TEST(MakeMotion, PointsThatCoincideHaveNoSize) {
  const auto m = make_motion(PairKind::edge_edge, {});
  EXPECT_EQ(largest_size(m), 0);
}

// Bug: a difference of positions overflows, and the decision has nothing to go by.
TEST(MakeMotion, LargestDoublesChangeNoBitEither) {
  Random random(3);
  for (const PairKind kind : {PairKind::vertex_face, PairKind::edge_edge})
    for (int i = 0; i < 100; ++i) {
      const auto motion = placed(family_named("random").make(kind, random), {"", 0x1p-3, 0});
      const auto m = make_motion(kind, to_points(motion), 0x1p-20);
      for (const double scale : {0x1p1020, 0x1p1021, 0x1p1022, 0x1p1023}) {
        const auto scaled = make_motion(kind, to_points(placed(motion, {"", scale, 0})), 0x1p-20 * scale);
        EXPECT_EQ(m.d.at0.x, scaled.d.at0.x);
        EXPECT_EQ(m.e.at1.y, scaled.e.at1.y);
        EXPECT_EQ(m.f.at0.z, scaled.f.at0.z);
        EXPECT_EQ(m.size_e, scaled.size_e);
        EXPECT_EQ(m.separation, scaled.separation);
      }
    }
}

}  // namespace
}  // namespace tamis::test

// Pairs whose four points stay in one plane: no sign tells doubles anything of them, but axes between the two often do.
#include <gtest/gtest.h>

#include "pair/exact/exact.hpp"
#include "pair/narrow/contact_normal.hpp"
#include "pair/narrow/decide.hpp"
#include "support/ask_pair.hpp"
#include "support/pair_cases.hpp"

namespace tamis::test {
namespace {

/// All four vertices on points of a plane that no axis knows, with small whole coordinates, and so at the end.
PairPoints in_one_plane(Random& random) {
  const auto somewhere = [&]() -> std::array<double, 3> {
    const double x = random.below(9), y = random.below(9);
    return {3 * x + y, x - 5 * y, 7 * x + 2 * y};
  };
  PairPoints points;
  for (auto* at : {&points.start, &points.end})
    for (auto& p : *at) p = somewhere();
  return points;
}

/// Of an edge of a sheet beside a parallel one of another sheet, which slides past.
PairPoints sliding(Random& random) {
  const std::array<double, 3> along{3, 1, 7}, beside{1, -5, 2}, up{0.0625, 0.0078125, -0.03125};
  const auto at = [&](double x, double y, double z) -> std::array<double, 3> {
    return {x * along[0] + y * beside[0] + z * up[0], x * along[1] + y * beside[1] + z * up[1],
            x * along[2] + y * beside[2] + z * up[2]};
  };
  const double x0 = random.below(3) - 1, y0 = random.below(5) - 2, x1 = random.below(3) - 1, y1 = random.below(5) - 2;
  return {{at(0, 0, 0), at(1, 0, 0), at(x0, y0, 4), at(x0 + 1, y0, 4)},
          {at(0, 0, 0), at(1, 0, 0), at(x1, y1, 4), at(x1 + 1, y1, 4)}};
}

// Bug: an axis is believed that does not keep the pair apart all the time.
TEST(CoplanarPairs, AreDecidedAsIntegersDecideThem) {
  Random random(3);
  for (const PairKind kind : {PairKind::vertex_face, PairKind::edge_edge}) {
    int touching = 0, free = 0;
    PrecisionCount decided_by;
    for (int i = 0; i < 3000 && !HasFailure(); ++i) {
      const PairPoints points = in_one_plane(random);
      const bool touches = decide_exactly(kind, points).touches();
      EXPECT_EQ(decide(PairInStep(kind, points), decided_by).touches, touches)
          << describe(kind, {points.start, points.end});
      ++(touches ? touching : free);
    }
    EXPECT_GT(touching, 300);
    EXPECT_GT(free, 300);
    EXPECT_LT(decided_by.exact, static_cast<std::uint64_t>(touching) + static_cast<std::uint64_t>(free) / 4);
  }
}

// Each of them took integers, which cost ten times as much.
TEST(CoplanarPairs, WhatSlidesPastNeedsNoIntegers) {
  Random random(5);
  PrecisionCount decided_by;
  for (int i = 0; i < 300; ++i)
    EXPECT_FALSE(decide(PairInStep(PairKind::edge_edge, sliding(random)), decided_by).touches);
  EXPECT_EQ(decided_by.exact, 0u);
}

/// Edges that stay in a plane across an axis, which goes along it: a few sizes away from zero, or far.
PairPoints across_axis(Random& random, bool on_lattice) {
  const std::size_t axis = static_cast<std::size_t>(random.below(3));
  const double far[] = {0, 1, 1e3, 1e12};
  PairPoints points;
  for (auto* at : {&points.start, &points.end}) {
    const double height = far[random.below(4)] * random.between(-1, 1);
    for (auto& p : *at) {
      for (double& x : p) x = on_lattice ? random.below(9) : random.between(-1, 1);
      p[axis] = height;
    }
  }
  return points;
}

// Bug: an end that comes to the other edge is missed, taken for another, or comes before the one that is said to be
// first; or the way out leads to the wrong side.
TEST(CoplanarPairs, AcrossAnAxisTouchWhereAnEndComesToTheOtherEdge) {
  Random random(11);
  PrecisionCount decided_by;
  int touching = 0, free = 0;
  for (int i = 0; i < 6000 && !HasFailure(); ++i) {
    const PairPoints points = across_axis(random, i % 4 == 0);
    const PairInStep pair(PairKind::edge_edge, points);
    const Decision exact = decide_exactly(pair.kind, points);
    const std::uint64_t integers_before = decided_by.exact;
    const PairResult result = decide(pair, decided_by);
    SCOPED_TRACE(describe(pair.kind, {points.start, points.end}));
    ASSERT_EQ(result.touches, exact.touches());
    ++(result.touches ? touching : free);
    if (!result.touches || decided_by.exact > integers_before) continue;
    EXPECT_EQ(result.toi_lower, exact.lower);
    EXPECT_EQ(result.toi_upper, exact.upper);
    const ContactPlace place = contact_place(pair, {exact.lower, exact.upper});
    EXPECT_NEAR(result.u, place.u, 1e-6);
    EXPECT_NEAR(result.v, place.v, 1e-6);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(result.normal[k], place.normal[k], 1e-6);
  }
  EXPECT_GT(touching, 1000);
  EXPECT_GT(free, 1000);
  EXPECT_GT(decided_by.scalar, 1200u);  // the others touch at the start, most of them
}

}  // namespace
}  // namespace tamis::test

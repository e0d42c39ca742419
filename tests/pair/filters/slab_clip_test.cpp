// The slab clip answers with times: what it cuts off the step must be free.
#include "pair/filters/slab_clip.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/pair_cases.hpp"
#include "support/test_data.hpp"

namespace tamis::test {
namespace {

TimeInterval<double> clip(PairKind kind, const oracle::Motion& m) {
  const auto motion = make_motion(kind, to_points(m));
  const TimeInterval<double> step{0, 1};
  return kind == PairKind::vertex_face ? SlabClip::clip<PairKind::vertex_face>(motion, step)
                                       : SlabClip::clip<PairKind::edge_edge>(motion, step);
}

TEST(SlabClip, WhatIsCutOffIsFree) {
  const long cases = repetitions("TAMIS_FILTER_CASES", 60);
  Random random(37);
  for (const Family& family : kFamilies)
    for (const Placement& placement : kPlacements)
      for (long i = 0; i < cases && !HasFailure(); ++i)
        for (const PairKind kind : {PairKind::vertex_face, PairKind::edge_edge}) {
          const oracle::Motion m = permuted(kind, placed(family.make(kind, random), placement), random);
          const auto time = clip(kind, m);
          if (time.t_in > time.t_out) continue;  // culled: soundness_test.cpp
          ASSERT_GE(time.t_in, 0);
          ASSERT_LE(time.t_out, 1);
          EXPECT_FALSE(time.t_in > 0 && oracle::touches(kind, m, {0, time.t_in, true}))
              << "cut at the start, " << time.t_in << ": " << describe(kind, m);
          EXPECT_FALSE(time.t_out < 1 && oracle::touches(kind, m, {std::nextafter(time.t_out, 2.0), 1}))
              << "cut at the end, " << time.t_out << ": " << describe(kind, m);
        }
}

// An approaching pair, apart for half of the step: the clip must see it, not only keep quiet.
TEST(SlabClip, CutsTheTimeBeforeTheContact) {
  const oracle::Motion m{{{{0.25, 0.25, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                         {{{0.25, 0.25, -1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}};
  const auto time = clip(PairKind::vertex_face, m);
  EXPECT_NEAR(time.t_in, 0.5, 1e-12);
  EXPECT_NEAR(time.t_out, 0.5, 1e-12);
  EXPECT_LE(time.t_in, 0.5);
  EXPECT_GE(time.t_out, 0.5);
}

}  // namespace
}  // namespace tamis::test

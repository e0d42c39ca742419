// Proofs that a pair keeps a fraction of its distance, against a naive oracle: the distance at many times of the step.
#include "pair/distance/kept_gap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pair/distance/closest.hpp"
#include "pair/distance/start_gap.hpp"
#include "support/ask_pair.hpp"
#include "support/pair_cases.hpp"

namespace tamis::test {
namespace {

constexpr int kTimes = 64;

double distance_at(PairKind kind, const PairMotion<double>& m, double t) {
  const auto gap = closest_points(kind, at_time(m.e, t), at_time(m.f, t), at_time(m.d, t)).gap;
  return std::sqrt(dot(gap, gap));
}

/// The least distance at any of many times until `until`.
double least_distance(PairKind kind, const PairMotion<double>& m, double until) {
  double least = distance_at(kind, m, 0);
  for (int i = 1; i <= kTimes; ++i) least = std::min(least, distance_at(kind, m, until * i / kTimes));
  return least;
}

/// Calls visit(kind, motion) for pairs that move by different parts of their size, and have a separation or none.
template <class Visit>
void for_each_motion(unsigned seed, const Visit& visit) {
  Random random(seed);
  for (const char* family : {"random", "separated", "lattice", "uneven"})
    for (int i = 0; i < 100; ++i)
      for (const PairKind kind : kAllKinds) {
        oracle::Motion motion = family_named(family).make(kind, random);
        const double way = std::ldexp(1.0, -random.below(6));
        for (std::size_t v = 0; v < 4; ++v)
          for (std::size_t axis = 0; axis < 3; ++axis)
            motion.end[v][axis] = motion.start[v][axis] + way * (motion.end[v][axis] - motion.start[v][axis]);
        SCOPED_TRACE(family + std::string(": ") + describe(kind, motion));
        visit(kind, make_motion(kind, to_points(motion), random.coin() ? 0 : 0x1p-4));
      }
}

// Bugs: the fraction is taken of the distance in place of the clearance beyond the separation; a part of the time or
// the separation itself is left out. Each would let a step go on too long.
TEST(KeptGap, IsProvenOnlyOfPairsThatKeepTheirFractionAtEveryTime) {
  int proven = 0;
  for_each_motion(1, [&](PairKind kind, const PairMotion<double>& m) {
    for (const double fraction : {0.1, 0.5, 0.9})
      for (const double until : {0.25, 1.0}) {
        const double kept = m.separation + fraction * std::max(distance_at(kind, m, 0) - m.separation, 0.0);
        with_kind(kind, [&](auto k) {
          const KeptGap<k(), double> gap(m, fraction);
          for (const int parts : {1, kTurningGapParts}) {
            if (!gap.is_kept(until, parts)) continue;
            ++proven;
            EXPECT_GT(least_distance(kind, m, until), kept) << fraction << " until " << until;
          }
          if (gap.is_kept_to_end()) {
            EXPECT_GT(least_distance(kind, m, 1), kept) << fraction << " to the end";
          }
        });
      }
  });
  EXPECT_GT(proven, 1000) << "the proof must be of use, too";
}

// Bug: the distance at t=0, blurred by floats, is taken as it is measured: what must be kept is then too little.
TEST(KeptGap, ProvesLessWhereTheStartIsBlurred) {
  for_each_motion(2, [](PairKind kind, const PairMotion<double>& m) {
    with_kind(kind, [&](auto k) {
      const double blur = 0x1p-3;
      if (!(KeptGap<k(), double>(m, 0.5, blur).is_kept_to_end())) return;
      const double kept = m.separation + 0.5 * std::max(distance_at(kind, m, 0) + blur - m.separation, 0.0);
      EXPECT_GT(least_distance(kind, m, 1), kept);
    });
  });
}

// Bugs: the gap along an axis that is not divided by its length; a corner's speed left out. Then a pair is culled that
// is fast enough to end the step.
TEST(StartGap, ExceedsTheReachOnlyOfPairsTooSlowToCoverTheirClearance) {
  int exceeding = 0;
  for_each_motion(3, [&](PairKind kind, const PairMotion<double>& m) {
    for (const double fraction : {0.1, 0.5, 0.9}) {
      const bool exceeds = with_kind(kind, [&](auto k) { return StartGap::exceeds<k()>(m, 1 / (1 - fraction)); });
      if (!exceeds) continue;
      ++exceeding;
      const double kept = m.separation + fraction * (distance_at(kind, m, 0) - m.separation);
      EXPECT_GE(least_distance(kind, m, 1), kept) << fraction;
    }
  });
  EXPECT_GT(exceeding, 300) << "the test must be of use, too";
}

}  // namespace
}  // namespace tamis::test

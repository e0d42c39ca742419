// How long one axis keeps a pair apart, against a naive oracle: signs at many places, distances at many times.
#include "pair/distance/axis_clip.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "pair/distance/orthogonal_axis.hpp"
#include "support/ask_pair.hpp"
#include "support/pair_cases.hpp"

namespace tamis::test {
namespace {

constexpr int kPlaces = 200;
constexpr double kNever = std::numeric_limits<double>::infinity();

// Bug: a root found too late, as where the discriminant rounds below zero: a time at which a corner is no longer apart
// would count as proven.
TEST(FirstRoot, IsNeverBehindAPlaceWhereTheQuadraticIsNotPositive) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const double c0 = random.unit(), c1 = random.between(-4, 4), c2 = random.coin() ? random.between(-4, 4) : 0;
    const double root = first_root(c0, c1, c2);
    ASSERT_GE(root, 0);
    for (int j = 1; j < kPlaces; ++j) {
      const double x = std::min(root, 8.0) * j / kPlaces;
      EXPECT_GT(c0 + x * (c1 + x * c2), -0x1p-40) << c0 << ", " << c1 << ", " << c2 << " at " << x;
    }
  }
}

TEST(FirstRoot, IsZeroWhereTheQuadraticBeginsAtZeroAndBeyondTheStepWhereItStaysPositive) {
  EXPECT_EQ(first_root(0.0, 1.0, 1.0), 0);
  EXPECT_EQ(first_root(-1.0, 4.0, 0.0), 0);
  EXPECT_GT(first_root(1.0, 1.0, 0.0), 0x1p40);  // a lower bound of none: far beyond the step
  EXPECT_EQ(first_root(1.0, -1.0, 1.0), kNever);
  EXPECT_NEAR(first_root(1.0, -2.0, 0.0), 0.5, 0x1p-40);
  EXPECT_NEAR(first_root(1.0, 0.0, -4.0), 0.5, 0x1p-40);
}

// Bug: a NaN of a degenerate axis, which would compare as proven.
TEST(FirstRoot, IsZeroWhereACoefficientIsNotANumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(first_root(nan, 1.0, 1.0), 0);
  EXPECT_EQ(first_root(1.0, nan, 1.0), 0);
}

double clipped_distance_at(PairKind kind, const PairMotion<double>& m, double t) {
  const auto gap = closest_points(kind, at_time(m.e, t), at_time(m.f, t), at_time(m.d, t)).gap;
  return std::sqrt(dot(gap, gap));
}

// Bugs: a sign of the turn; the growing length of an axis that turns; going backwards as if forwards.
TEST(AxisClip, KeepsPairsBeyondTheirSeparationAtAllTimesItClaims) {
  Random random(2);
  int claimed = 0;
  for (const char* family : {"random", "separated", "lattice"})
    for (int i = 0; i < 100; ++i)
      for (const PairKind kind : kAllKinds) {
        const oracle::Motion motion = family_named(family).make(kind, random);
        const PairMotion<double> m = make_motion(kind, to_points(motion), random.coin() ? 0 : 0x1p-5);
        const double now = random.unit();
        SCOPED_TRACE(describe(kind, motion));
        with_kind(kind, [&](auto k) {
          const AxisClip<k(), double> clip(m);
          const auto closest = closest_points<k()>(at_time(m.e, now), at_time(m.f, now), at_time(m.d, now));
          const TurningAxis<double> turning = orthogonal_axis<k()>(m, now, closest);
          for (const TurningAxis<double>& axis : {turning, TurningAxis<double>{turning.direction}}) {
            const double until = std::min(clip.apart_until(now, axis), 1.0);
            const double since = std::max(clip.apart_since(now, axis), 0.0);
            claimed += until > now;
            for (int j = 0; j <= kPlaces; ++j) {
              const double part = j / double{kPlaces};
              if (until > now) {
                EXPECT_GT(clipped_distance_at(kind, m, now + part * (until - now)), m.separation) << until;
              }
              if (since < now) {
                EXPECT_GT(clipped_distance_at(kind, m, now - part * (now - since)), m.separation) << since;
              }
            }
          }
        });
      }
  EXPECT_GT(claimed, 500) << "the axis must be of use, too";
}

}  // namespace
}  // namespace tamis::test
